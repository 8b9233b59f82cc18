/* Steps scenes as the embedded simulator does: the same operations in the same order, so that every number is the same.
 *
 * What each part restates is named above it; whoever changes one changes both, and `benchmarks/native_gate.py` shows
 * whether they still agree. Compiled without contraction of products and sums, and without fast mathematics.
 * Positions [m], headings [rad], speeds [m/s], times [s] throughout.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#ifndef SOURCE_DIGEST
#define SOURCE_DIGEST ""
#endif

#define PI 3.141592653589793
#define TAU (2.0 * PI)
#define AIR_DRAG 0.0008
#define REVERSE_SPEED 6.0
#define LEAST_REVERSAL 0.05
#define FINE 0.1
#define SIGHT 15.0
#define RANGE 50.0
#define HORIZON 100.0
#define PREVIEW 6
#define EYE 0.75
#define BEHIND_NOSE 2.2
#define NEAREST 6
#define PER_ACTOR 11
#define OWN 14
#define ACTORS_SIZE (OWN + NEAREST * PER_ACTOR)
#define ROAD_SIZE (ACTORS_SIZE + 2)
#define TRAFFIC_SIZE (ROAD_SIZE + 1)
#define USUAL 8.0
#define UNHELD 100.0
#define ALLOWED ROAD_SIZE
#define STACK 64
#define LOCALS 8
#define ARGUMENTS 6
#define MOST_TURNS 1000
#define MOST_BODIES 32
#define PART 16 /* segments, or moments, whose box tells of all of them that they are far */

enum { THING, VEHICLE, WALKER };
enum { GOES_ON, COLLISION, ARRIVED, TIMEOUT, OVER };
enum { SAFEBENCH, ACTORS, ROAD, TRAFFIC };
#define STEPS 20 /* that the planner looks ahead */
#define WAYS 49 /* that it weighs */
#define EXPECTED (4 * NEAREST)

enum { RULE_BASED, INTELLIGENT_DRIVER, NETWORK, PLANNER, TRAFFIC_DRIVER };
enum { RELU, TANH };             /* what comes after each layer of a network but the last */
enum { BY_TANH, BY_CLIP, BY_SIGMOID, BY_WAY }; /* what comes after the last */
enum { NO_FAULT, TURNS_IN_PLACE };

typedef struct {
    int64_t points;
    const double *x, *y, *s, *hx, *hy; /* x, y, s: one per point; hx, hy: one per segment */
    const double *boxes; /* of each PART segments: least and greatest x, least and greatest y; or none */
} Line;

/* chatscene.terms.profile.Timetable: s, seconds: one per point; speeds: one per segment. */
typedef struct {
    int64_t points;
    const double *s, *seconds, *speeds;
} Timetable;

typedef struct {
    double length, width, throttle, brake, top_speed, wheelbase, wheel_angle, wheel_rate, lateral, drag;
} Limits;

typedef struct {
    double x, y, heading, speed, before, cos, sin, half_length, half_width, radius, grip;
    double throttle, brake, steer, wheel;  /* of vehicles */
    double course, target_speed, vx, vy;   /* of walkers; a course of vehicles that slide, too */
    double sight, height;                  /* from how far the ego sees it; 0 where nothing hides anybody */
    double was_x, was_y, was_heading;      /* before the last step */
    double even_speed, even_heading, even_distance; /* when it became quiet; the distance from the ego */
    double spin;                           /* how far a vehicle that slides turns for each metre */
    Limits limits;
    int32_t kind, reverse, walks, seen_as_vehicle;
    int32_t backs, together;               /* drives backwards, and is carried as it goes; is with the ego */
    int32_t slides;
} Body;

/* Conditions and numbers: programs for a stack. */
enum {
    CONST, LOCAL, ALONG, OFFSET, GAP, SPEED, HEADING, BRAKED, ABS, MAX, MIN, ADD, SUB, MUL, DIV, NEG,
    LT, LE, GT, GE, EQ, NE, AND, OR, NOT, SELECT, SECONDS
};

typedef struct {
    int32_t op, a, b, c;
    double value;
} Instruction;

typedef struct {
    int64_t start, count;
} Code;

enum {
    DRIVE_PATH, BRAKE_ON_PATH, THROTTLE_ON_PATH, SWERVE_ON_PATH, WEAVE_ON_PATH, PACE_ON_PATH, KEEP_STATION,
    FOLLOW_TRAFFIC, WAIT_FOR, REVERSE_STRAIGHT, REVERSE_TURNING, TURN_OFF, SLIDE, PARK, MOVE_AHEAD, HALT
};
enum { NEVER, UNTIL, AFTER };

typedef struct {
    int32_t primitive, path, other, end;  /* path: index of a line; other: of a body; -1 for none */
    int32_t values, first_local;          /* how many names are computed before, and the first one's place */
    Code value[LOCALS], argument[ARGUMENTS], condition;
    const double *caps;                   /* the speed at which each segment of the path can be driven */
} Phase;

typedef struct {
    int32_t body, phase, phases, loop, entered, begun; /* loop: where to go on after the last phase, -1 for nowhere */
    int64_t since;                                     /* step at which the phase began */
    int32_t near, other_near;                          /* segments to search from, -1 for the whole line */
    int32_t passed, last;                              /* last: the phase from which on it does nothing new */
    double until;                                      /* where the ego is when it no longer waits for it */
    double along, seconds, ahead, turned, before, course;
    double argument[ARGUMENTS], local[LOCALS];
    double straight[8];                                /* the two points of a line straight ahead */
    const Phase *list;
} Agent;

typedef struct {
    double at_most, since, till, place, braking, at_least, aside, over, back, within, met; /* met: since when it counts */
    int64_t of, agent, phase; /* indices of the body that it waits for and of its plan, and a phase; -1 for none */
    int64_t ends;             /* whether it ends then */
} Order;

typedef struct {
    int64_t ring_start, rings, lane;
    double low_x, low_y, high_x, high_y;
} Area; /* a polygon: its outline, then its holes */

typedef struct {
    int64_t start, points;
} Ring;

typedef struct {
    int64_t step, other, side;
    double speed, earlier;
} Contact;

typedef struct {
    int64_t bodies, agents, areas, orders, limit, step, moving, contacts, most_contacts;
    int64_t quiet;                                      /* the step since which nothing happens, -1 while something does */
    int32_t ending, through, preset, near, fault, ends_when_over, moved, unused;
    double dt, arrival, along, offset, hardest, wheelbase, wheel_angle; /* the last two: of an ego that is no car */
    double swept; /* how far two must move past each other in a step to be looked at within it */
    double beyond, settled, wanted; /* where the ego has its manoeuvre behind it; when the last light changes */
    uint64_t touching;
    Body *body;
    Agent *agent;
    const Line *line;
    const Timetable *table;
    const Instruction *code;
    const Area *area;
    const Ring *ring;
    const double *corner; /* x, y of the corners of rings */
    Order *order;
    double *row, *offsets;  /* what is kept of each state: 4 numbers per body that moves; the ego's offset */
    Contact *contact;
    const double *room;    /* of each point of the ego's route, left and right of it; where the ego sees the road */
    const double *allowed; /* of each segment of the ego's route, the speed; where the ego sees it */
    double seen[TRAFFIC_SIZE];
} World;

typedef struct {
    int64_t inputs, outputs;
    const float *columns, *bias; /* columns: for each input its weight to each output */
} Layer;

/* What the planner weighs its ways by; discount: what a crash counts that it expects then. */
typedef struct {
    double speed, crash, graze, braking, braked, starting, started, stepping, stepped, crossing, room, side, widening;
    double berth, haste, offset, astray, jerk, resolve, agility, drift, discount[STEPS];
} Caution;

/* Somebody's foot on the brake, beside whoever drives; own: what becomes of that one's own braking. */
typedef struct {
    int64_t begins, over;
    double own, full, ramp, standstill, standing;
    Limits car;
} Foot;

/* Who drives: by rule, or a network. */
typedef struct {
    int32_t kind, hidden, output, every; /* every: at which steps it decides; between, it holds */
    int32_t swift, around; /* whether it sees `traffic`; whether it heeds everybody, not only who is in its lane */
    double softness;       /* of chatscene.ego.at_speed */
    Limits car;            /* what drivers by rule take their own car for */
    Caution caution;
    int64_t layers;
    const Layer *layer;
    float *one, *other; /* room for what the widest layer takes and gives */
    int32_t *told;      /* room for which of these are not zero */
    int64_t remembers;  /* of how many steps it is known what a network answered last, and to what */
    double *memory;     /* of each of them what it saw, what it was to drive at most, and both answers */
} Policy;

const char *source_digest(void) { return SOURCE_DIGEST; }
/* Of judging: the boxes of one body at some moments. */
typedef struct {
    const double *x, *y, *cos, *sin;
    double half_length, half_width;
} Boxes;

/* What `sum_up` looks for; `measure.sums` has where each is said. */
typedef struct {
    int64_t lately, over, within, pause;
    double dt, crawl, as_near, reacts, still, gains, same_way, air, across, fast, standing, behind;
} Habits;

/* A course: the points of a line by arc length, how x and y change along each piece, and where each leads. */
typedef struct {
    int64_t points;
    const double *arc, *x, *y, *x_rate, *y_rate, *cos, *sin;
} Course;

int64_t size_of(int64_t what) {
    switch (what) {
    case 0: return sizeof(Line);
    case 1: return sizeof(Body);
    case 2: return sizeof(Instruction);
    case 3: return sizeof(Phase);
    case 4: return sizeof(Agent);
    case 5: return sizeof(World);
    case 6: return sizeof(Layer);
    case 7: return sizeof(Policy);
    case 8: return sizeof(Foot);
    case 9: return sizeof(Boxes);
    case 10: return sizeof(Course);
    case 11: return sizeof(Habits);
    default: return -1;
    }
}

/* math.hypot of CPython 3.10 and later for two numbers: scaled, with products and sums kept in two parts. */
static double hypotenuse(double a, double b) {
    const double split = 134217729.0;
    double part[2] = {fabs(a), fabs(b)}, largest = part[0] > part[1] ? part[0] : part[1];
    if (largest == 0.0) return 0.0;
    int exponent;
    frexp(largest, &exponent);
    if (exponent < -1023) return hypot(a, b);
    double scale = ldexp(1.0, -exponent), sum = 1.0, f1 = 0.0, f2 = 0.0, f3 = 0.0, x, t, high, low, old;
    for (int i = 0; i < 2; i++) {
        x = part[i] * scale;
        t = x * split;
        high = t - (t - x);
        low = x - high;
        x = high * high; old = sum; sum += x; f1 += (old - sum) + x;
        x = 2.0 * high * low; old = sum; sum += x; f2 += (old - sum) + x;
        f3 += low * low;
    }
    double h = sqrt(sum - 1.0 + (f1 + f2 + f3));
    x = h;
    t = x * split;
    high = t - (t - x);
    low = x - high;
    x = -high * high; old = sum; sum += x; f1 += (old - sum) + x;
    x = -2.0 * high * low; old = sum; sum += x; f2 += (old - sum) + x;
    x = -low * low; old = sum; sum += x; f3 += (old - sum) + x;
    x = sum - 1.0 + (f1 + f2 + f3);
    return (h + x / (2.0 * h)) / scale;
}

/* Python's % of floats. */
static double modulo(double a, double b) {
    double m = fmod(a, b);
    if (m != 0.0) return (b < 0.0) != (m < 0.0) ? m + b : m;
    return copysign(0.0, b);
}

/* `round(value, 6)`, of numbers up to a thousand: to the nearest of the decimals, to an even one from between. */
static double six_decimals(double value) {
    __float128 exact = (__float128)fabs(value) * 1e6;
    int64_t below = (int64_t)exact;
    __float128 rest = exact - below;
    if (rest > 0.5 || (rest == 0.5 && below & 1)) below++;
    return copysign((double)below / 1e6, value);
}

/* For the check at loading: each function that the engine takes from elsewhere, on many numbers. */
void evaluate(int64_t function, int64_t count, const double *a, const double *b, double *out) {
    for (int64_t i = 0; i < count; i++) {
        double x = a[i], y = b[i];
        switch (function) {
        case 0: out[i] = sin(x); break;
        case 1: out[i] = cos(x); break;
        case 2: out[i] = tan(x); break;
        case 3: out[i] = atan(x); break;
        case 4: out[i] = asin(sin(x)); break;
        case 5: out[i] = atan2(x, y); break;
        case 6: out[i] = hypotenuse(x, y); break;
        case 7: out[i] = modulo(x, y); break;
        case 8: out[i] = pow(x, 2.0); break;
        case 9: out[i] = pow(x, 4.0); break;
        case 10: out[i] = remainder(x, TAU); break;
        case 11: out[i] = tanh(x); break;
        case 12: out[i] = six_decimals(sin(x)); break;
        case 13: out[i] = hypot(x, y); break;
        default: out[i] = 0.0;
        }
    }
}

/* chatscene.terms.polyline.Polyline */
static double distance2(const Line *line, int64_t i, double x, double y) {
    double rx = x - line->x[i], ry = y - line->y[i], hx = line->hx[i], hy = line->hy[i];
    double along = rx * hx + ry * hy, length = line->s[i + 1] - line->s[i];
    double beyond = along < 0.0 ? along : along > length ? along - length : 0.0;
    double across = hx * ry - hy * rx;
    return beyond * beyond + across * across;
}

/* How far a point is from a segment of a line, squared, as `nearest_segment` has it. */
static double apart2(const Line *line, int64_t i, double x, double y) {
    double dx = line->x[i + 1] - line->x[i], dy = line->y[i + 1] - line->y[i];
    double rx = x - line->x[i], ry = y - line->y[i];
    double t = (rx * dx + ry * dy) / (dx * dx + dy * dy);
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    double ex = rx - t * dx, ey = ry - t * dy;
    return ex * ex + ey * ey;
}

/* How far a point is from a box, squared. */
static double outside2(const double *e, double x, double y) {
    double dx = x < e[0] ? e[0] - x : x > e[1] ? x - e[1] : 0.0, dy = y < e[2] ? e[2] - y : y > e[3] ? y - e[3] : 0.0;
    return dx * dx + dy * dy;
}

/* Whether a point is farther than the root of `square` from wherever a box is, more than rounding makes. */
static int far_from(const double *e, double x, double y, double square) {
    return outside2(e, x, y) > square * (1.0 + 1e-9) + 1e-9;
}

/* The first of the nearest segments; past the parts of a line that are farther than one of the nearest part. */
static int32_t nearest_segment(const Line *line, double x, double y) {
    int32_t best = 0, segments = (int32_t)line->points - 1;
    double least = INFINITY, within = INFINITY;
    if (line->boxes && segments > PART) {
        int32_t part = 0;
        double nearest = INFINITY;
        for (int32_t k = 0; k * PART < segments; k++) {
            double d2 = outside2(line->boxes + 4 * k, x, y);
            if (d2 < nearest) { nearest = d2; part = k; }
        }
        for (int32_t i = part * PART; i < (part + 1) * PART && i < segments; i++) {
            double d2 = apart2(line, i, x, y);
            if (d2 < within) within = d2;
        }
    }
    for (int32_t first = 0; first < segments; first += PART) {
        if (line->boxes && far_from(line->boxes + first / PART * 4, x, y, within)) continue;
        for (int32_t i = first; i < first + PART && i < segments; i++) {
            double d2 = apart2(line, i, x, y);
            if (d2 < least) { least = d2; best = i; }
        }
    }
    return best;
}

static void project(const Line *line, double x, double y, int32_t *from, double *arc, double *offset) {
    int32_t near = *from < 0 ? nearest_segment(line, x, y) : *from, last = (int32_t)line->points - 2;
    double best = distance2(line, near, x, y), d2;
    while (near < last && (d2 = distance2(line, near + 1, x, y)) <= best) { near++; best = d2; }
    while (near > 0 && (d2 = distance2(line, near - 1, x, y)) < best) { near--; best = d2; }
    double rx = x - line->x[near], ry = y - line->y[near], hx = line->hx[near], hy = line->hy[near];
    double along = rx * hx + ry * hy, across = hx * ry - hy * rx, start = line->s[near], end = line->s[near + 1];
    *from = near;
    if (along < 0.0) {
        *arc = start;
        *offset = near > 0 ? copysign(hypotenuse(along, across), across) : across;
        return;
    }
    double beyond = along - (end - start);
    if (beyond > 0.0) {
        *arc = end;
        *offset = near < last ? copysign(hypotenuse(beyond, across), across) : across;
        return;
    }
    *arc = start + along;
    *offset = across;
}

/* Where points lie on a line; each is looked for from where the one before it was, or on the whole line. */
void follow(const Line *line, int64_t count, int32_t whole, const double *x, const double *y, double *arc, double *offset) {
    int32_t near = -1;
    for (int64_t i = 0; i < count; i++) {
        if (whole) near = -1;
        project(line, x[i], y[i], &near, &arc[i], &offset[i]);
    }
}

static int64_t segment_at(const Line *line, double s) {
    int64_t low = 0, high = line->points - 2;
    while (low < high) {
        int64_t middle = (low + high + 1) / 2;
        if (line->s[middle] <= s) low = middle; else high = middle - 1;
    }
    return low;
}

/* `Polyline.segment` */
static void segment(const Line *line, int64_t i, double out[4]) {
    int64_t last = line->points - 2;
    out[0] = i > last ? line->x[last + 1] : line->x[i];
    out[1] = i > last ? line->y[last + 1] : line->y[i];
    out[2] = line->hx[i > last ? last : i];
    out[3] = line->hy[i > last ? last : i];
}

/* chatscene.simulate.embedded.dynamics */
static double next_speed(const Body *b, double dt) {
    const Limits *limits = &b->limits;
    double speed = b->speed, grip = b->grip, fade = 1.0 - fabs(speed) / limits->top_speed;
    double throttle = b->throttle < 0.0 ? 0.0 : b->throttle > 1.0 ? 1.0 : b->throttle;
    double brake = b->brake < 0.0 ? 0.0 : b->brake > 1.0 ? 1.0 : b->brake;
    double push = limits->throttle * throttle * (fade > 0.0 ? fade : 0.0);
    push = push < grip ? push : grip;
    double braked = limits->brake * brake;
    double resist = (braked < grip ? braked : grip) + limits->drag + AIR_DRAG * speed * speed;
    int forward = speed > LEAST_REVERSAL || (speed >= -LEAST_REVERSAL && !b->reverse);
    double sign = forward ? 1.0 : -1.0;
    if (forward == b->reverse) { resist = resist + push; push = 0.0; }
    double rolling = sign * speed;
    rolling += rolling > 0.0 || push > resist ? (push - resist) * dt : 0.0;
    rolling = rolling < 0.0 ? 0.0 : rolling;
    int onward = forward != b->backs;
    return sign * (onward || rolling < REVERSE_SPEED ? rolling : REVERSE_SPEED);
}

static void step_sliding(Body *b, double dt) {
    double old = b->before = b->speed, speed = next_speed(b, dt), mean = 0.5 * (old + speed);
    b->x += mean * cos(b->course) * dt;
    b->y += mean * sin(b->course) * dt;
    b->heading += b->spin * mean * dt;
    b->cos = cos(b->heading);
    b->sin = sin(b->heading);
    b->speed = speed;
}

static void step_vehicle(Body *b, double dt) {
    if (b->slides) {
        step_sliding(b, dt);
        return;
    }
    const Limits *limits = &b->limits;
    double old = b->before = b->speed, speed = next_speed(b, dt);
    double asked = -(b->steer > 1.0 ? 1.0 : b->steer < -1.0 ? -1.0 : b->steer) * limits->wheel_angle;
    double most = limits->wheel_rate * dt, turn = asked - b->wheel;
    b->wheel += turn > most ? most : turn < -most ? -most : turn;
    double mean = 0.5 * (old + speed);
    if (b->wheel == 0.0) {
        b->x += mean * b->cos * dt;
        b->y += mean * b->sin * dt;
    } else if (mean > 1e-6 || mean < -1e-6) {
        double curvature = tan(b->wheel) / limits->wheelbase;
        double lateral = limits->lateral < b->grip ? limits->lateral : b->grip;
        double tightest = lateral / (mean * mean);
        curvature = curvature > tightest ? tightest : curvature < -tightest ? -tightest : curvature;
        double slip = atan(0.5 * limits->wheelbase * curvature);
        slip = b->backs ? -slip : slip;
        double turned = mean * curvature * cos(slip) * dt, course = b->heading + slip + 0.5 * turned;
        b->x += mean * cos(course) * dt;
        b->y += mean * sin(course) * dt;
        b->heading += turned;
        b->cos = cos(b->heading);
        b->sin = sin(b->heading);
    }
    b->speed = speed;
}

static void step_walker(Body *b, double dt) {
    const Limits *limits = &b->limits;
    b->before = b->speed;
    double wish = b->target_speed < 0.0 ? 0.0 : b->target_speed;
    wish = limits->top_speed < wish ? limits->top_speed : wish;
    double ax = wish * cos(b->course) - b->vx, ay = wish * sin(b->course) - b->vy, change = hypotenuse(ax, ay);
    double able = wish >= b->speed ? limits->throttle : limits->brake;
    double most = (b->grip < able ? b->grip : able) * dt;
    if (change > most) { ax = ax * most / change; ay = ay * most / change; }
    double vx = b->vx + ax, vy = b->vy + ay;
    b->x += 0.5 * (b->vx + vx) * dt;
    b->y += 0.5 * (b->vy + vy) * dt;
    b->vx = vx;
    b->vy = vy;
    b->speed = hypotenuse(vx, vy);
    if (b->speed > 0.05) {
        double facing = atan2(vy, vx);
        b->heading += modulo(facing - b->heading + PI, TAU) - PI;
        b->cos = vx / b->speed;
        b->sin = vy / b->speed;
    }
}

/* chatscene.simulate.contact */
static int touch(const Body *a, const Body *b) {
    double dx = b->x - a->x, dy = b->y - a->y, reach = a->radius + b->radius;
    if (dx * dx + dy * dy > reach * reach) return 0;
    double c = fabs(a->cos * b->cos + a->sin * b->sin), s = fabs(a->cos * b->sin - a->sin * b->cos);
    return fabs(dx * a->cos + dy * a->sin) <= a->half_length + b->half_length * c + b->half_width * s
        && fabs(dy * a->cos - dx * a->sin) <= a->half_width + b->half_length * s + b->half_width * c
        && fabs(dx * b->cos + dy * b->sin) <= b->half_length + a->half_length * c + a->half_width * s
        && fabs(dy * b->cos - dx * b->sin) <= b->half_width + a->half_length * s + a->half_width * c;
}

/* `between` */
static Body within_step(const Body *b, double share) {
    Body then = *b;
    then.x = b->was_x + (b->x - b->was_x) * share;
    then.y = b->was_y + (b->y - b->was_y) * share;
    then.heading = b->was_heading + (b->heading - b->was_heading) * share;
    then.cos = cos(then.heading);
    then.sin = sin(then.heading);
    return then;
}

/* How long before the end of a step two began to touch, as a share of it; negative if they do not. */
static double met(const Body *a, const Body *b, double swept) {
    double dx = b->x - a->x, dy = b->y - a->y;
    double mx = dx - (b->was_x - a->was_x), my = dy - (b->was_y - a->was_y), moved = sqrt(mx * mx + my * my);
    if (moved > swept) {
        double reach = a->radius + b->radius + moved;
        if (dx * dx + dy * dy > reach * reach) return -1.0;
        int64_t parts = (int64_t)ceil(moved / FINE);
        for (int64_t part = 1; part < parts; part++) {
            double share = (double)part / (double)parts;
            Body one = within_step(a, share), other = within_step(b, share);
            if (touch(&one, &other)) return 1.0 - share;
        }
    }
    return touch(a, b) ? 0.0 : -1.0;
}

enum { FRONT, REAR, LEFT, RIGHT };

static int contact_side(const Body *ego, const Body *other) {
    double dx = other->x - ego->x, dy = other->y - ego->y;
    double along = dx * ego->cos + dy * ego->sin, across = dy * ego->cos - dx * ego->sin;
    double c = fabs(ego->cos * other->cos + ego->sin * other->sin);
    double s = fabs(ego->cos * other->sin - ego->sin * other->cos);
    double depth_along = ego->half_length + other->half_length * c + other->half_width * s - fabs(along);
    double depth_across = ego->half_width + other->half_length * s + other->half_width * c - fabs(across);
    if (depth_along < depth_across) return along > 0 ? FRONT : REAR;
    return across > 0 ? LEFT : RIGHT;
}

/* Which side of a line a point lies on: its sign, decided in more digits where rounding could turn it. */
static int orientation(double x1, double y1, double x2, double y2, double x, double y) {
    double left = (x1 - x) * (y2 - y), right = (y1 - y) * (x2 - x), det = left - right;
    double bound = 4.0 * DBL_EPSILON * (fabs(left) + fabs(right));
    if (det > bound) return 1;
    if (det < -bound) return -1;
    __float128 exact = ((__float128)x1 - x) * ((__float128)y2 - y) - ((__float128)y1 - y) * ((__float128)x2 - x);
    return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

/* Where a point lies in a ring, as GEOS decides it, who stands behind shapely.contains_xy: 1 inside, -1 outside, 0 on. */
static int in_ring(const double *corner, int64_t points, double x, double y) {
    int crossings = 0;
    for (int64_t i = 0; i + 1 < points; i++) {
        double x1 = corner[2 * i], y1 = corner[2 * i + 1], x2 = corner[2 * i + 2], y2 = corner[2 * i + 3];
        if (x1 < x && x2 < x) continue;
        if (x2 == x && y2 == y) return 0;
        if (y1 == y && y2 == y) {
            if ((x1 < x2 ? x1 : x2) <= x && x <= (x1 < x2 ? x2 : x1)) return 0;
            continue;
        }
        if ((y1 > y && y2 <= y) || (y2 > y && y1 <= y)) {
            int side = orientation(x1, y1, x2, y2, x, y);
            if (side == 0) return 0;
            if ((y2 < y1 ? -side : side) > 0) crossings ^= 1;
        }
    }
    return crossings ? 1 : -1;
}

static int in_area(const World *w, const Area *area, double x, double y) {
    if (x < area->low_x || x > area->high_x || y < area->low_y || y > area->high_y) return 0;
    for (int64_t i = 0; i < area->rings; i++) {
        const Ring *ring = &w->ring[area->ring_start + i];
        if (in_ring(w->corner + 2 * ring->start, ring->points, x, y) != (i ? -1 : 1)) return 0;
    }
    return 1;
}

/* `RouteSurroundings.same_lane`; a lane's areas follow each other. */
static int same_lane(const World *w, double x, double y, double other_x, double other_y) {
    for (int64_t i = 0; i < w->areas;) {
        int64_t lane = w->area[i].lane;
        int one = 0, other = 0;
        for (; i < w->areas && w->area[i].lane == lane; i++) {
            other |= in_area(w, &w->area[i], other_x, other_y);
            one |= in_area(w, &w->area[i], x, y);
        }
        if (one && other) return 1;
    }
    return 0;
}

static int64_t segment_in(const Timetable *t, double s) {
    int64_t low = 0, high = t->points - 1; /* the last segment that begins at s or before */
    while (high - low > 1) {
        int64_t middle = (low + high) / 2;
        if (t->s[middle] <= s) low = middle; else high = middle;
    }
    return low;
}

static double passed(const Timetable *t, double s) {
    int64_t i = segment_in(t, s);
    return t->seconds[i] + (s - t->s[i]) / t->speeds[i];
}

/* `Timetable.time_from` */
static double seconds_to(const Timetable *t, double start, double speed, double to, double gain) {
    double usual = t->speeds[segment_in(t, start)], seconds = passed(t, to) - passed(t, start);
    double left = to - start, missing = usual - speed;
    if (missing <= 0.0 || left <= 0.0) return seconds;
    if (left * 2.0 * gain >= usual * usual - speed * speed) return seconds + missing * missing * (0.5 / gain) / usual;
    double gaining = (sqrt(speed * speed + 2.0 * gain * left) - speed) / gain;
    return gaining > seconds ? gaining : seconds;
}

/* Programs for a stack: what the functions of chatscene.world.places say of poses. */
static double evaluated(const World *w, const Agent *agent, Code code) {
    double stack[STACK];
    int top = -1;
    for (int64_t k = code.start; k < code.start + code.count; k++) {
        const Instruction *i = &w->code[k];
        const Body *b = i->b >= 0 ? &w->body[i->b] : 0;
        double arc, offset;
        int32_t near = -1;
        switch (i->op) {
        case CONST: stack[++top] = i->value; break;
        case LOCAL: stack[++top] = agent->local[i->a]; break;
        case ALONG: project(&w->line[i->a], b->x, b->y, &near, &arc, &offset); stack[++top] = arc; break;
        case OFFSET: project(&w->line[i->a], b->x, b->y, &near, &arc, &offset); stack[++top] = offset; break;
        case GAP: stack[++top] = hypotenuse(w->body[i->a].x - b->x, w->body[i->a].y - b->y); break;
        case SPEED: stack[++top] = b->speed; break;
        case HEADING: stack[++top] = b->heading; break;
        case BRAKED: stack[++top] = pow(b->speed, 2.0) / i->value; break;
        case SECONDS:
            project(&w->line[i->a], b->x, b->y, &near, &arc, &offset);
            stack[top] = seconds_to(&w->table[i->c], arc, b->speed, stack[top], i->value);
            break;
        case ABS: stack[top] = fabs(stack[top]); break;
        case NEG: stack[top] = -stack[top]; break;
        case NOT: stack[top] = stack[top] == 0.0; break;
        case SELECT:
            top -= 2;
            stack[top] = stack[top + 2] != 0.0 ? stack[top] : stack[top + 1];
            break;
        default: {
            double r = stack[top--], l = stack[top];
            stack[top] = i->op == MAX ? (r > l ? r : l) : i->op == MIN ? (r < l ? r : l)
                : i->op == ADD ? l + r : i->op == SUB ? l - r : i->op == MUL ? l * r : i->op == DIV ? l / r
                : i->op == LT ? l < r : i->op == LE ? l <= r : i->op == GT ? l > r : i->op == GE ? l >= r
                : i->op == EQ ? l == r : i->op == NE ? l != r
                : i->op == AND ? l != 0.0 && r != 0.0 : l != 0.0 || r != 0.0;
        }
        }
    }
    return stack[top];
}

/* chatscene.world.control */
static void pedals(double speed, double wish, Body *b) {
    double error = wish - speed;
    if (error >= -0.1) {
        double throttle = 0.06 + 0.5 * error;
        b->throttle = throttle < 1.0 ? throttle : 1.0;
        b->brake = 0.0;
    } else {
        double brake = -0.3 * error;
        b->throttle = 0.0;
        b->brake = brake < 1.0 ? brake : 1.0;
    }
}

static double allowed(const Line *line, const double *caps, Agent *agent, const Body *b, double speed) {
    double offset;
    project(line, b->x, b->y, &agent->near, &agent->along, &offset);
    double cap = caps ? caps[agent->near] : INFINITY;
    return cap < speed ? cap : speed;
}

static double steering(const Line *line, const Agent *agent, const Body *b, double left) {
    double look = 0.6 * fabs(b->speed), ahead = agent->along + (look > 4.0 ? look : 4.0);
    int64_t i = segment_at(line, ahead);
    double d = ahead - line->s[i], px = line->x[i] + d * line->hx[i], py = line->y[i] + d * line->hy[i];
    if (left != 0.0) {
        double direction = atan2(line->hy[i], line->hx[i]);
        px -= left * sin(direction);
        py += left * cos(direction);
    }
    double dx = px - b->x, dy = py - b->y, bearing = atan2(dy, dx) - b->heading, distance = hypotenuse(dx, dy);
    double curvature = 2.0 * sin(bearing) / (1e-3 > distance ? 1e-3 : distance);
    double wheel = atan(b->limits.wheelbase * curvature), steer = -wheel / b->limits.wheel_angle;
    steer = steer < 1.0 ? steer : 1.0;
    return steer > -1.0 ? steer : -1.0;
}

/* A phase begins: its values and arguments are computed. */
static void enter(World *w, Agent *agent, const Phase *phase) {
    for (int i = 0; i < phase->values; i++)
        agent->local[phase->first_local + i] = evaluated(w, agent, phase->value[i]);
    for (int i = 0; i < ARGUMENTS && phase->argument[i].count; i++)
        agent->argument[i] = evaluated(w, agent, phase->argument[i]);
    if (phase->end == AFTER) agent->seconds = evaluated(w, agent, phase->condition) / w->dt;
    agent->since = w->step;
    agent->entered = 1;
    agent->begun = 0;
}

/* The primitive of a phase begins to act. */
static void begin(World *w, Agent *agent, const Phase *phase) {
    const Body *b = &w->body[agent->body];
    double offset, own, others;
    int32_t near;
    agent->near = agent->other_near = -1;
    agent->along = agent->turned = 0.0;
    agent->before = b->heading;
    agent->begun = 1;
    if (phase->primitive == KEEP_STATION) {
        near = -1;
        project(&w->line[phase->path], b->x, b->y, &near, &own, &offset);
        near = -1;
        project(&w->line[phase->path], w->body[phase->other].x, w->body[phase->other].y, &near, &others, &offset);
        agent->ahead = own - others;
    }
    if (phase->primitive == MOVE_AHEAD) {
        agent->course = b->heading + agent->argument[1];
        double *p = agent->straight;
        p[0] = b->x;
        p[1] = b->x + 60.0 * cos(agent->course);
        p[2] = b->y;
        p[3] = b->y + 60.0 * sin(agent->course);
        p[4] = 0.0;
        p[5] = hypotenuse(p[1] - p[0], p[3] - p[2]);
        p[6] = (p[1] - p[0]) / p[5];
        p[7] = (p[3] - p[2]) / p[5];
    }
}

/* chatscene.world.places.followingSpeed; lengths and widths as of bodies */
static double following(const World *w, const Agent *agent, const Line *line, double wish) {
    const Body *b = &w->body[agent->body];
    double along, at, beside, far = wish * wish / (2 * 2.5) + 0.5 * 40.0, sight = far > 40.0 ? far : 40.0;
    int32_t near = -1;
    project(line, b->x, b->y, &near, &along, &beside);
    for (int64_t i = 0; i < w->bodies; i++) {
        const Body *o = &w->body[i];
        if (i == agent->body || hypotenuse(o->x - b->x, o->y - b->y) > sight) continue;
        int32_t from = near;
        project(line, o->x, o->y, &from, &at, &beside);
        if (at > along && fabs(beside) < 1.3 + 0.5 * o->limits.width) {
            double room = at - along - 0.5 * (b->limits.length + o->limits.length) - 3.0;
            double speed = o->speed < 0.0 ? 0.0 : o->speed;
            double able = room > 0.0 ? sqrt(pow(speed, 2.0) + 2 * 2.5 * room) : 0.0;
            wish = able < wish ? able : wish;
        }
    }
    return wish;
}

/* chatscene/world/behaviors.scenic: what the body is asked for this step; 0 if the primitive has ended. */
static int acts(World *w, Agent *agent, const Phase *phase, Body *b) {
    const Line *line = phase->path >= 0 ? &w->line[phase->path] : 0;
    const double *a = agent->argument, *caps = phase->caps;
    const Body *other = phase->other >= 0 ? &w->body[phase->other] : 0;
    Line straight = {2, agent->straight, agent->straight + 2, agent->straight + 4, agent->straight + 6,
                     agent->straight + 7, NULL};
    double arc, offset, steer = 0.0, wish;
    int reverse = 0;
    if (!agent->begun) begin(w, agent, phase);
    else if (phase->primitive == TURN_OFF) {
        agent->turned += remainder(b->heading - agent->before, TAU);
        agent->before = b->heading;
    }
    switch (phase->primitive) {
    case DRIVE_PATH:
        pedals(b->speed, allowed(line, caps, agent, b, a[0]), b);
        steer = steering(line, agent, b, 0.0 + a[1]);
        break;
    case BRAKE_ON_PATH:
        allowed(line, caps, agent, b, 0.0);
        steer = steering(line, agent, b, 0.0 + a[1]);
        b->throttle = 0.0;
        b->brake = a[0];
        break;
    case THROTTLE_ON_PATH:
        allowed(line, caps, agent, b, a[2]);
        steer = steering(line, agent, b, 0.0 + a[1]);
        b->throttle = b->speed < a[2] ? a[0] : 0.0;
        b->brake = 0.0;
        break;
    case SWERVE_ON_PATH:
        allowed(line, caps, agent, b, a[0]);
        pedals(b->speed, a[0], b);
        steer = steering(line, agent, b, 0.0 + a[1]);
        break;
    case WEAVE_ON_PATH: {
        double time = (double)(w->step - agent->since) * w->dt;
        double left = a[1] * sin(2 * PI * time / a[2]);
        pedals(b->speed, allowed(line, caps, agent, b, a[0]), b);
        steer = steering(line, agent, b, left + 0.0);
        break;
    }
    case PACE_ON_PATH:
    case KEEP_STATION: {
        int keeps = phase->primitive == KEEP_STATION;
        double ahead = keeps ? agent->ahead : a[0], top = keeps ? 25.0 : a[1], least = keeps ? a[0] : a[2];
        project(line, other->x, other->y, &agent->other_near, &arc, &offset);
        allowed(line, caps, agent, b, top);
        wish = other->speed + 0.8 * (arc + ahead - agent->along);
        wish = wish > least ? wish : least;
        wish = top < wish ? top : wish;
        pedals(b->speed, allowed(line, caps, agent, b, wish), b);
        steer = steering(line, agent, b, 0.0);
        break;
    }
    case WAIT_FOR: /* the other is the ego, and the way that it has to go is its route */
        if (!agent->passed) {
            int32_t near = -1;
            project(&w->line[0], other->x, other->y, &near, &arc, &offset);
            if (a[1] - arc > -8) {
                b->throttle = 0.0;
                b->brake = 1.0;
                break;
            }
            agent->passed = 1;
        }
        /* fall through */
    case FOLLOW_TRAFFIC:
        wish = following(w, agent, line, a[0]);
        pedals(b->speed, allowed(line, caps, agent, b, wish), b);
        steer = steering(line, agent, b, 0.0);
        break;
    case REVERSE_STRAIGHT:
        pedals(-b->speed, a[0], b);
        reverse = 1;
        break;
    case REVERSE_TURNING:
        pedals(-b->speed, a[0], b);
        steer = a[1];
        reverse = 1;
        break;
    case TURN_OFF: {
        if (!(fabs(agent->turned) < fabs(a[0]))) return 0;
        double wheel = atan(b->limits.wheelbase / a[2]) / b->limits.wheel_angle;
        steer = -copysign(wheel < 1.0 ? wheel : 1.0, a[0]);
        pedals(b->speed, a[1], b);
        break;
    }
    case SLIDE:
        if (!b->slides) b->course = b->heading;
        b->slides = 1;
        b->spin = a[0];
        b->throttle = b->steer = 0.0;
        b->brake = a[1];
        b->reverse = 0;
        return 1;
    case MOVE_AHEAD:
        if (b->kind == WALKER) {
            b->course = agent->course;
            b->target_speed = a[0];
            return 1;
        }
        pedals(b->speed, allowed(&straight, 0, agent, b, a[0]), b);
        steer = steering(&straight, agent, b, 0.0);
        break;
    default: /* PARK, HALT */
        if (b->kind == WALKER) {
            b->course = b->heading;
            b->target_speed = 0.0;
            return 1;
        }
        b->throttle = 0.0;
        b->brake = 1.0;
    }
    b->steer = steer;
    b->reverse = reverse;
    b->slides = 0;
    return 1;
}

/* One step of an agent's plan. It reads poses alone, and writes what is asked of its own body. */
static void behave(World *w, Agent *agent) {
    for (int turn = 0; turn < MOST_TURNS; turn++) {
        if (agent->phase < 0 || agent->phase >= agent->phases) return;
        const Phase *phase = &agent->list[agent->phase];
        if (!agent->entered) enter(w, agent, phase);
        int over = phase->end == UNTIL ? evaluated(w, agent, phase->condition) != 0.0
            : phase->end == AFTER ? (double)(w->step - agent->since) >= agent->seconds : 0;
        if (!over && acts(w, agent, phase, &w->body[agent->body])) return;
        agent->entered = agent->begun = agent->passed = 0;
        agent->phase++;
        if (agent->phase == agent->phases && agent->loop >= 0) agent->phase = agent->loop;
    }
    w->fault = TURNS_IN_PLACE;
}

/* chatscene.ego.observation */
static double heading_error(double hx, double hy, double heading) {
    double cross = hx * sin(heading) - hy * cos(heading);
    return asin(cross > 1.0 ? 1.0 : cross < -1.0 ? -1.0 : cross);
}

static void see_four_numbers(World *w) {
    const Body *ego = &w->body[0];
    double at[4];
    int ahead = 0;
    for (int64_t i = 1; i < w->bodies && !ahead; i++) {
        const Body *o = &w->body[i];
        if (!o->seen_as_vehicle) continue;
        double dx = o->x - ego->x, dy = o->y - ego->y;
        if (dx * dx + dy * dy < SIGHT * SIGHT && dx * ego->cos + dy * ego->sin > 0.0)
            ahead = same_lane(w, ego->x, ego->y, o->x, o->y);
    }
    segment(&w->line[0], w->near + PREVIEW, at);
    w->seen[0] = at[2] * (ego->y - at[1]) - at[3] * (ego->x - at[0]);
    w->seen[1] = heading_error(at[2], at[3], ego->heading);
    w->seen[2] = fabs(ego->speed);
    w->seen[3] = ahead ? 1.0 : 0.0;
}

static void see_actor(const World *w, const Body *ego, const Body *o, double *out) {
    const Line *line = &w->line[0];
    double along, beside, at[4];
    int32_t near = w->near;
    project(line, o->x, o->y, &near, &along, &beside);
    if (along <= 0.0) {
        segment(line, 0, at);
        along = (o->x - at[0]) * at[2] + (o->y - at[1]) * at[3];
        along = 0.0 < along ? 0.0 : along;
    } else if (along >= line->s[line->points - 1]) {
        segment(line, (int64_t)near + 1, at);
        double more = (o->x - at[0]) * at[2] + (o->y - at[1]) * at[3];
        along += 0.0 > more ? 0.0 : more;
    }
    double dx = o->x - ego->x, dy = o->y - ego->y, turned = o->heading - ego->heading;
    out[0] = 1.0;
    out[1] = along - w->along;
    out[2] = beside;
    out[3] = dx * ego->cos + dy * ego->sin;
    out[4] = dy * ego->cos - dx * ego->sin;
    out[5] = o->speed * cos(turned);
    out[6] = o->speed * sin(turned);
    out[7] = remainder(turned, TAU);
    out[8] = o->half_length;
    out[9] = o->half_width;
    out[10] = o->walks ? 1.0 : 0.0;
}

/* chatscene.terms.sight */
static int stops(const Body *box, const double *eye, double px, double py, double pz) {
    double dx = eye[0] - box->x, dy = eye[1] - box->y;
    double at[2] = {dx * box->cos + dy * box->sin, dy * box->cos - dx * box->sin};
    dx = px - eye[0];
    dy = py - eye[1];
    double way[2] = {dx * box->cos + dy * box->sin, dy * box->cos - dx * box->sin};
    double half[2] = {box->half_length, box->half_width}, enter = 0.0, leave = 1.0;
    for (int i = 0; i < 2; i++) {
        if (way[i] == 0.0) {
            if (at[i] <= -half[i] || at[i] >= half[i]) return 0;
            continue;
        }
        double first = (-half[i] - at[i]) / way[i], second = (half[i] - at[i]) / way[i];
        double near = first < second ? first : second, far = first < second ? second : first;
        enter = near > enter ? near : enter;
        leave = far < leave ? far : leave;
    }
    if (!(enter < leave)) return 0;
    double rise = pz - eye[2];
    return eye[2] + rise * (rise < 0.0 ? leave : enter) < box->height;
}

static int point_hidden(const World *w, const Body *of, const double *eye, double px, double py) {
    for (int64_t i = 1; i < w->bodies; i++)
        if (&w->body[i] != of && stops(&w->body[i], eye, px, py, of->height)) return 1;
    return 0;
}

static int is_hidden(const World *w, const Body *of) {
    const Body *ego = &w->body[0];
    if (!(ego->height > 0.0)) return 0;
    double ahead = ego->half_length - BEHIND_NOSE;
    ahead = ahead > 0.0 ? ahead : 0.0;
    double eye[3] = {ego->x + ahead * ego->cos, ego->y + ahead * ego->sin, EYE * ego->height};
    double lx = of->half_length * of->cos, ly = of->half_length * of->sin;
    double sx = -of->half_width * of->sin, sy = of->half_width * of->cos;
    if (!point_hidden(w, of, eye, of->x, of->y)) return 0;
    for (int a = 1; a >= -1; a -= 2)
        for (int b = 1; b >= -1; b -= 2)
            if (!point_hidden(w, of, eye, of->x + (a * lx + b * sx), of->y + (a * ly + b * sy))) return 0;
    return 1;
}

static const double AHEAD[5] = {5.0, 10.0, 15.0, 20.0, 30.0};

static void see_actors(World *w, double scale) {
    const Body *ego = &w->body[0];
    const Line *line = &w->line[0];
    double *seen = w->seen, at[4], distance[NEAREST];
    int64_t found[NEAREST], count = 0;
    segment(line, w->near, at);
    double left = line->s[line->points - 1] - w->along, horizon = scale * HORIZON, reach = scale * RANGE;
    seen[0] = ego->speed;
    seen[1] = w->offset;
    seen[2] = heading_error(at[2], at[3], ego->heading);
    seen[3] = left < horizon ? left : horizon;
    for (int i = 0; i < 5; i++) {
        double s = w->along + scale * AHEAD[i];
        int64_t k = segment_at(line, s);
        double d = s - line->s[k];
        double dx = line->x[k] + d * line->hx[k] - ego->x, dy = line->y[k] + d * line->hy[k] - ego->y;
        seen[4 + 2 * i] = dx * ego->cos + dy * ego->sin;
        seen[5 + 2 * i] = dy * ego->cos - dx * ego->sin;
    }
    for (int64_t i = 1; i < w->bodies; i++) { /* the nearest, by distance and then by order */
        const Body *o = &w->body[i];
        double d = hypotenuse(o->x - ego->x, o->y - ego->y);
        if (!(d < (o->sight < reach ? o->sight : reach)) || is_hidden(w, o)) continue;
        int64_t k = count < NEAREST ? count++ : NEAREST;
        while (k > 0 && d < distance[k - 1]) {
            if (k < NEAREST) { distance[k] = distance[k - 1]; found[k] = found[k - 1]; }
            k--;
        }
        if (k < NEAREST) { distance[k] = d; found[k] = i; }
    }
    for (int64_t k = 0; k < NEAREST; k++) {
        double *out = seen + OWN + PER_ACTOR * k;
        if (k < count) see_actor(w, ego, &w->body[found[k]], out);
        else for (int j = 0; j < PER_ACTOR; j++) out[j] = 0.0;
    }
}

/* `SteppedSession._look`: what is kept of a state, what the ego sees of it, whether it is the last. */
static void locate(World *w) { project(&w->line[0], w->body[0].x, w->body[0].y, &w->near, &w->along, &w->offset); }

/* `RouteView._beside`. */
static void see_room(World *w, double scale) {
    const double *s = w->line[0].s;
    int64_t near = w->near, points = w->line[0].points;
    double end = s[near] + scale * AHEAD[4], *room = &w->seen[ACTORS_SIZE];
    room[0] = w->room[2 * near];
    room[1] = w->room[2 * near + 1];
    for (int64_t i = near + 1; i < points && (i == near + 1 || s[i] <= end); i++) {
        if (w->room[2 * i] < room[0]) room[0] = w->room[2 * i];
        if (w->room[2 * i + 1] < room[1]) room[1] = w->room[2 * i + 1];
    }
}

static void see(World *w) {
    if (w->preset == SAFEBENCH) { see_four_numbers(w); return; }
    double far = w->preset == TRAFFIC ? w->body[0].speed / USUAL : 1.0, scale = far > 1.0 ? far : 1.0;
    see_actors(w, scale);
    if (w->preset == ACTORS) return;
    see_room(w, scale);
    if (w->preset == TRAFFIC) w->seen[ROAD_SIZE] = w->allowed[w->near] < UNHELD ? w->allowed[w->near] : UNHELD;
}

/* chatscene.simulate.over */
#define QUIET 2.0
#define LONG 5.0
#define AT_REST 0.1
#define APART 3.0
#define FOLLOWED 16
#define FOLLOW_STRIDE 0.5
#define EVEN_SPEED 0.5
#define EVEN_HEADING 0.1
#define AS_FAR 0.5
#define IN_THE_WAY 1.0

static int is_to_come(const Order *o, double time, double along, int rests) {
    if (time < o->since + (isnan(o->aside) ? 0.0 : o->over)) return 1;
    return (time < o->till && o->till < INFINITY) || (!rests && along < o->place);
}

static int is_parted(const World *w, const Body *b, int rests) {
    const Body *ego = &w->body[0];
    const Line *line = &w->line[0];
    double dx = b->x - ego->x, dy = b->y - ego->y, vx = b->speed * b->cos, vy = b->speed * b->sin, at, beside;
    if (b->slides) {
        vx = b->speed * cos(b->course);
        vy = b->speed * sin(b->course);
    }
    if (dx * (vx - ego->speed * ego->cos) + dy * (vy - ego->speed * ego->sin) <= 0.0) return 0;
    double fast = fabs(ego->speed), other = fabs(b->speed);
    double least = APART * (other > fast ? other : fast) + ego->radius + b->radius;
    if (hypotenuse(dx, dy) <= least) return 0;
    if (!rests && b->speed <= w->wanted) {
        int32_t near = -1;
        project(line, b->x, b->y, &near, &at, &beside);
        if (at > w->along && fabs(beside) < ego->half_width + b->radius + IN_THE_WAY) return 0;
    }
    for (int k = 1; k <= FOLLOWED; k++) {
        double time = k * FOLLOW_STRIDE, s = w->along + fast * time;
        int64_t i = segment_at(line, s);
        double d = s - line->s[i], x = line->x[i] + d * line->hx[i], y = line->y[i] + d * line->hy[i];
        if (hypotenuse(b->x + vx * time - x, b->y + vy * time - y) <= least) return 0;
    }
    return 1;
}

/* How long it has to remain as it is; 0 where something is to come. Says of each body whether it is with the ego. */
static double lasts(World *w) {
    const Body *ego = &w->body[0];
    double time = (double)w->step * w->dt;
    int waits = 0, rests = fabs(ego->speed) < AT_REST, stays = 0, together = 0;
    for (int64_t i = 0; i < w->agents; i++) {
        const Agent *a = &w->agent[i];
        if (a->phase >= a->last && w->along >= a->until) continue;
        if (a->phase < a->last && a->list[a->phase].end != UNTIL) return 0.0;
        waits = 1;
    }
    for (int64_t i = 0; i < w->orders; i++) {
        const Order *o = &w->order[i];
        if (is_to_come(o, time - o->met, w->along, rests)) return 0.0;
        stays |= rests && o->at_most == 0.0;
    }
    if ((rests && !(w->moved || stays)) || (waits && !rests)) return 0.0;
    if (w->along < w->beyond && (!rests || time < w->settled)) return 0.0;
    for (int64_t i = 1; i < w->bodies; i++) {
        Body *b = &w->body[i];
        b->together = 0;
        if (rests && fabs(b->speed) < AT_REST) continue;
        if (waits) return 0.0;
        together |= b->together = !is_parted(w, b, rests);
    }
    return waits || together ? LONG : QUIET;
}

static double apart(const World *w, const Body *b) { return hypotenuse(b->x - w->body[0].x, b->y - w->body[0].y); }

static int is_over(World *w) {
    w->moved |= fabs(w->body[0].speed) >= AT_REST;
    double time = lasts(w);
    if (time == 0.0) { w->quiet = -1; return 0; }
    int even = w->quiet >= 0, steady = fabs(w->body[0].speed - w->body[0].even_speed) <= EVEN_SPEED;
    for (int64_t i = 1; i < w->bodies && even; i++) {
        const Body *b = &w->body[i];
        even = fabs(b->speed - b->even_speed) <= EVEN_SPEED && fabs(b->heading - b->even_heading) <= EVEN_HEADING
            && (!b->together || (apart(w, b) - b->even_distance >= -AS_FAR
                                 && (steady || apart(w, b) - b->even_distance <= AS_FAR)));
    }
    if (!even) {
        w->quiet = w->step;
        for (int64_t i = 0; i < w->bodies; i++) {
            Body *b = &w->body[i];
            b->even_speed = b->speed;
            b->even_heading = b->heading;
            b->even_distance = apart(w, b);
        }
    }
    return (double)(w->step - w->quiet) * w->dt >= time;
}

static void look(World *w) {
    const Body *ego = &w->body[0];
    locate(w);
    if (w->row) {
        double *row = w->row + 4 * w->moving * w->step;
        for (int64_t i = 0; i < w->bodies; i++) {
            const Body *b = &w->body[i];
            if (b->kind == THING) continue;
            row[0] = b->x;
            row[1] = b->y;
            row[2] = b->heading;
            row[3] = b->speed;
            row += 4;
        }
        w->offsets[w->step] = w->offset;
    }
    see(w);
    int passed = 0;
    for (int64_t i = 1; i < w->bodies; i++) {
        const Body *o = &w->body[i];
        if (w->touching >> i & 1) {
            if (!touch(ego, o)) w->touching &= ~(1ULL << i);
            continue;
        }
        double earlier = met(ego, o, w->swept);
        if (earlier < 0.0) continue;
        if (w->contacts < w->most_contacts) {
            Contact *contact = &w->contact[w->contacts++];
            Body mine = earlier > 0.0 ? within_step(ego, 1.0 - earlier) : *ego;
            Body theirs = earlier > 0.0 ? within_step(o, 1.0 - earlier) : *o;
            contact->step = w->step;
            contact->other = i;
            contact->side = contact_side(&mine, &theirs);
            double goes = o->slides ? o->course : o->was_heading;
            contact->speed = hypotenuse(ego->before * cos(ego->was_heading) - o->before * cos(goes),
                                        ego->before * sin(ego->was_heading) - o->before * sin(goes));
            contact->earlier = earlier;
        }
        if (touch(ego, o)) w->touching |= 1ULL << i; else passed = 1;
    }
    w->ending = (w->touching || passed) && !w->through ? COLLISION : w->along >= w->arrival ? ARRIVED
        : w->ends_when_over && is_over(w) ? OVER : w->step >= w->limit ? TIMEOUT : GOES_ON;
}

/* chatscene.terms.order and chatscene.simulate.obedience.Obedience */
static void obey(World *w, Body *ego) {
    double time = (double)w->step * w->dt, along = w->along + ego->speed * w->dt, most = INFINITY, least = 0.0;
    double left = NAN, back = 0.0;
    for (int64_t i = 0; i < w->orders; i++) {
        Order *o = &w->order[i];
        if (o->of >= 0) {
            const Body *other = &w->body[o->of];
            int so_far = o->phase >= 0 && o->agent >= 0 && w->agent[o->agent].phase >= o->phase;
            if (so_far || hypotenuse(other->x - ego->x, other->y - ego->y) <= o->within) {
                o->of = -1;
                o->met = o->ends ? INFINITY : time;
            }
        }
        if (o->met == INFINITY) continue;
        double for_time = time - o->met, then = for_time + w->dt;
        if (then < o->till) {
            double wait = o->since - then, way = o->place - along;
            double in_time = o->at_most + o->braking * (0.0 > wait ? 0.0 : wait);
            double in_place = sqrt(pow(o->at_most, 2.0) + 2.0 * o->braking * (0.0 > way ? 0.0 : way));
            double allows = in_place > in_time ? in_place : in_time;
            most = allows < most ? allows : most;
        }
        if (!(o->since <= for_time && for_time < o->till && w->along >= o->place)) continue;
        least = o->at_least > least ? o->at_least : least;
        back = o->back > back ? o->back : back;
        if (!isnan(o->aside)) {
            double done = o->over > 0.0 ? (for_time - o->since) / o->over : 1.0;
            left = o->aside * (done < 1.0 ? done : 1.0);
        }
    }
    ego->reverse = 0;
    if (back > 0.0 || ego->speed < -0.1) { /* Obedience.backs */
        ego->throttle = ego->steer = 0.0;
        ego->brake = 1.0;
        if (back > 0.0 && ego->speed <= 0.1) {
            pedals(-ego->speed, back, ego);
            ego->reverse = 1;
        }
        return;
    }
    if (!isnan(left)) {
        Agent driver = {.along = w->along};
        ego->steer = steering(&w->line[0], &driver, ego, left);
    }
    if (most == 0.0 && ego->speed < 0.1) {
        ego->throttle = 0.0;
        ego->brake = 1.0;
        return;
    }
    const Limits *limits = &ego->limits;
    double after = ego->speed + (limits->throttle * ego->throttle - limits->brake * ego->brake) * w->dt;
    if (after <= most) {
        if (after < least && least <= most) pedals(ego->speed, least, ego);
        return;
    }
    double needed = ((ego->speed - most) / w->dt - limits->drag) / limits->brake;
    needed = 0.0 > needed ? 0.0 : needed;
    needed = 1.0 < needed ? 1.0 : needed;
    ego->throttle = 0.0;
    ego->brake = needed > ego->brake ? needed : ego->brake;
}

/* `SteppedSession.step`, after the action has become pedals. */
void step_world(World *w, double throttle, double brake, double steer) {
    Body *ego = &w->body[0];
    ego->throttle = throttle;
    ego->brake = brake;
    ego->steer = steer;
    if (w->orders) obey(w, ego);
    for (int64_t i = 0; i < w->agents; i++) behave(w, &w->agent[i]);
    if (w->fault) return;
    for (int64_t i = 0; i < w->bodies; i++) {
        w->body[i].was_x = w->body[i].x;
        w->body[i].was_y = w->body[i].y;
        w->body[i].was_heading = w->body[i].heading;
        if (w->body[i].kind == VEHICLE) step_vehicle(&w->body[i], w->dt);
        else if (w->body[i].kind == WALKER) step_walker(&w->body[i], w->dt);
    }
    w->step++;
    look(w);
}

/* chatscene.ego.policy.controls */
static void press(World *w, double acceleration, double steering_) {
    acceleration = acceleration < -1.0 ? -1.0 : acceleration;
    acceleration = 1.0 < acceleration ? 1.0 : acceleration;
    steering_ = steering_ < -1.0 ? -1.0 : steering_;
    double steer = 0.3 * (1.0 < steering_ ? 1.0 : steering_);
    if (w->wheelbase > 0.0) { /* on the circle on which a car then turns */
        steer = atan(w->wheelbase * (tan(steer * 1.22) / 2.85)) / w->wheel_angle;
        steer = steer > -1.0 ? steer : -1.0;
        steer = steer < 1.0 ? steer : 1.0;
    }
    if (acceleration > 0.0) step_world(w, acceleration, 0.0, steer);
    else step_world(w, 0.0, -acceleration * w->hardest, steer);
}

static int64_t room_for(int64_t size, int64_t count) { return size * (count > 1 ? count : 1); }

/* How much of memory a scene takes that changes as it is stepped, but for what is kept of each state. */
int64_t room_of(const World *w) {
    return room_for(sizeof(Body), w->bodies) + room_for(sizeof(Agent), w->agents) +
           room_for(sizeof(Order), w->orders) + room_for(sizeof(Contact), w->most_contacts);
}

static void *copied(char **room, const void *from, int64_t size, int64_t count, int64_t most) {
    void *to = memcpy(*room, from, size * count);
    *room += room_for(size, most);
    return to;
}

/* The same scene as far as it is, to be stepped by itself: in so much room, and so that it keeps its states apart. */
void copy_world(const World *from, World *to, char *room, double *row, double *offsets) {
    *to = *from;
    to->body = copied(&room, from->body, sizeof(Body), from->bodies, from->bodies);
    to->agent = copied(&room, from->agent, sizeof(Agent), from->agents, from->agents);
    to->order = copied(&room, from->order, sizeof(Order), from->orders, from->orders);
    to->contact = copied(&room, from->contact, sizeof(Contact), from->contacts, from->most_contacts);
    to->row = memcpy(row, from->row, sizeof(double) * 4 * from->moving * (from->step + 1));
    to->offsets = memcpy(offsets, from->offsets, sizeof(double) * (from->step + 1));
}

/* Scenes that are each stepped with an action of its own: what `told` and `seen` say of each is then in rows. The number
 * of one that is over, whose states have no room for more: then none is stepped; else -1. */
int64_t step_worlds(World **worlds, int64_t count, const double *action, double *told, double *seen, int64_t size) {
    for (int64_t i = 0; i < count; i++)
        if (worlds[i]->ending != GOES_ON) return i;
    for (int64_t i = 0; i < count; i++, action += 2, told += 6, seen += size) {
        World *w = worlds[i];
        told[0] = w->along;
        press(w, action[0], action[1]);
        told[1] = w->along;
        told[2] = w->offset;
        told[3] = w->body[0].speed;
        told[4] = w->ending;
        told[5] = w->fault;
        memcpy(seen, w->seen, size * sizeof(double));
    }
    return -1;
}

/* chatscene.ego.intelligent_driver.pressed */
static double pressed(const Limits *car, double a) {
    return a > 0.0 ? a / (3.0 * car->throttle / 4.5) : a / car->brake;
}

static double within_one(double value) {
    value = value < 1.0 ? value : 1.0;
    return value > -1.0 ? value : -1.0;
}

/* chatscene.ego.rule_based */
static void rule_based(double speed, const double *seen, double *acceleration, double *steer) {
    double wish = fabs(seen[1]) < 0.15 || speed < 5.5 ? speed : 5.5, a = 0.5 * (wish - seen[2]);
    if (seen[3] != 0.0) a = -1.0;
    *acceleration = within_one(a);
    *steer = within_one(0.35 * seen[0] + 1.6 * seen[1]);
}

/* chatscene.ego.intelligent_driver */
static double behind(const Limits *car, double speed, const double *row, double unhindered) {
    double along = row[1], beside = row[2], vx = row[5], vy = row[6];
    double c = fabs(cos(row[7])), s = fabs(sin(row[7]));
    double reach = row[8] * c + row[9] * s, breadth = row[8] * s + row[9] * c;
    double room = along - reach - car->length / 2, corridor = car->width / 2 + breadth + 0.5;
    int inside_now = fabs(beside + vy * 0.0) < corridor, meets = 0;
    if (along < 0.0) return unhindered;
    for (int i = 0; i <= 10; i++) {
        double later = i * 0.25, ahead = along + (vx - speed) * later;
        meets |= fabs(beside + vy * later) < corridor && ahead < speed * 1.0 + reach + car->length
            && ahead > -reach - car->length;
    }
    if (!(inside_now || meets)) return unhindered;
    double lead = inside_now || vx > 2.0 * fabs(vy) ? (0.0 > vx ? 0.0 : vx) : 0.0, closing = speed - lead;
    double distance = 0.1 > room - 1.0 ? 0.1 : room - 1.0;
    double needed = closing > 0.0 ? closing * closing / (2.0 * distance) : 0.0;
    if (needed > 2.0) return -(car->brake < 1.3 * needed ? car->brake : 1.3 * needed);
    double wanted = 2.5 + speed * 1.2 + speed * closing / (2.0 * sqrt(2.0 * 2.5));
    wanted = 2.5 > wanted ? 2.5 : wanted;
    double kept = unhindered - 2.0 * pow(wanted / (0.5 > room ? 0.5 : room), 2.0);
    return -2.5 > kept ? -2.5 : kept;
}

static double curve_speed(const double *seen) {
    double lowest = INFINITY;
    for (int i = 0; i < 5; i++) {
        double x = seen[4 + 2 * i], y = seen[5 + 2 * i], chord2 = x * x + y * y;
        if (fabs(y) > 0.05) {
            double radius = chord2 / (2.0 * fabs(y)), beyond = AHEAD[i] - AHEAD[1];
            double able = sqrt(3.0 * radius + 2.0 * 2.5 * (0.0 > beyond ? 0.0 : beyond));
            lowest = able < lowest ? able : lowest;
        }
    }
    return lowest;
}

static void intelligent_driver(const Limits *car, double wanted, const double *seen, double *acceleration,
                               double *steer) {
    double speed = seen[0], wish = curve_speed(seen);
    wish = wish < wanted ? wish : wanted;
    double ratio = speed / (0.1 > wish ? 0.1 : wish), slower = -2.0 * (speed - wish);
    double a = ratio < 1.0 ? 2.0 * (1.0 - pow(ratio, 4.0)) : slower > -2.5 ? slower : -2.5;
    for (const double *row = seen + OWN; row < seen + ACTORS_SIZE; row += PER_ACTOR) {
        if (!(row[0] > 0.0)) continue;
        double kept = behind(car, speed, row, a);
        a = kept < a ? kept : a;
    }
    double x = seen[4], y = seen[5], chord2 = x * x + y * y;
    double wheel = atan(car->wheelbase * (2.0 * y / (1.0 > chord2 ? 1.0 : chord2)));
    *acceleration = within_one(pressed(car, a));
    *steer = within_one(-wheel / car->wheel_angle / 0.3);
}

/* chatscene.ego.at_speed */
static double larger(double a, double b) { return a > b ? a : b; }
static double smaller(double a, double b) { return a < b ? a : b; }

typedef struct {
    double along, beside, ahead, left, speed, half_along, half_beside;
    const double *row;
} Near; /* somebody, along the route and beside it */

typedef struct {
    double middle[6], bearing[6];
} Bends; /* where the route leads */

static double scale(double speed) { return larger(1.0, speed / USUAL); }

static Bends bends_of(const double *seen, double k) {
    Bends b = {.bearing = {-seen[2]}};
    double x = seen[1] * sin(b.bearing[0]), y = -seen[1] * cos(b.bearing[0]), before = 0.0;
    for (int i = 0; i < 5; i++) {
        double px = seen[4 + 2 * i], py = seen[5 + 2 * i];
        b.middle[i + 1] = 0.5 * (before + AHEAD[i] * k);
        b.bearing[i + 1] = b.bearing[i] + remainder(atan2(py - y, px - x) - b.bearing[i], TAU);
        x = px;
        y = py;
        before = AHEAD[i] * k;
    }
    return b;
}

static double bearing_at(const Bends *b, double along) {
    int i = 0;
    if (along <= 0.0) return b->bearing[0];
    while (i < 5 && b->middle[i] <= along) i++;
    double turning = (b->bearing[i] - b->bearing[i - 1]) / (b->middle[i] - b->middle[i - 1]);
    return b->bearing[i - 1] + turning * (along - b->middle[i - 1]);
}

static Near other(const double *row, double k, const Bends *b) {
    Near o = {.along = row[1], .beside = row[2], .row = row};
    double sight = AHEAD[4] * k, way = bearing_at(b, smaller(o.along, sight)), c = cos(way), s = sin(way);
    o.ahead = row[5] * c + row[6] * s;
    o.left = row[6] * c - row[5] * s;
    c = fabs(cos(row[7] - way));
    s = fabs(sin(row[7] - way));
    if (o.along > sight && c > 0.7) {
        o.ahead = copysign(hypotenuse(o.ahead, o.left), o.ahead);
        o.left = s = 0.0;
        c = 1.0;
    }
    if (o.ahead < -2.0 * fabs(o.left)) o.left = copysign(larger(fabs(o.left) + 0.04 * o.ahead, 0.0), o.left);
    o.speed = hypotenuse(o.ahead, o.left);
    o.half_along = row[8] * c + row[9] * s;
    o.half_beside = row[8] * s + row[9] * c;
    return o;
}

static double slower(double speed, double wish) { return larger(3.0 * (wish - speed), -4.0); }

static double able_at(const Limits *car, double speed) {
    return larger(car->throttle * (1.0 - speed / car->top_speed) - car->drag - AIR_DRAG * speed * speed, 0.0);
}

static double pressed_at(const Limits *car, double acceleration, double speed) {
    double force = acceleration + car->drag + AIR_DRAG * speed * speed;
    if (force > 0.0) return smaller(force / larger(car->throttle * (1.0 - speed / car->top_speed), 0.1), 1.0);
    return larger(force / car->brake, -1.0);
}

static double steered(const Limits *car, double softness, const double *seen, double aside) {
    double v = larger(seen[0], 4.0), offset = seen[1], leads = -seen[2], c = cos(leads), s = sin(leads);
    double x = seen[4] - offset * s, y = seen[5] + offset * c, left = y * c - x * s;
    double bend = 2.0 * left / larger(x * x + y * y, 1.0), soft = 1.0 + softness * v * v;
    double most = smaller(1.5, 0.6 * v), able = 5.0 / soft;
    double sideways = larger(-most, smaller(most, (aside - offset) / (0.5 * (0.5 + 0.5 * soft))));
    double across = larger(-able, smaller(able, 5.0 * (sideways + v * s)));
    double wheel = atan(car->wheelbase * (soft * (bend + across / (v * v))));
    return within_one(-wheel / car->wheel_angle / 0.3);
}

/* chatscene.ego.traffic_driver */
static double held_back(const Limits *car, double speed, const Near *o, double unhindered) {
    if (o->along < 0.0) return unhindered;
    double room = o->along - o->half_along - car->length / 2, beside = fabs(o->beside);
    double corridor = car->width / 2 + o->half_beside + 0.5, sideways = fabs(o->left);
    int comes = o->beside * o->left < 0.0;
    double enters = beside < corridor ? 0.0 : comes ? (beside - corridor) / sideways : INFINITY;
    if (enters > 1.0) return unhindered;
    int crosses = sideways > 0.5 * o->speed;
    double lead = crosses ? 0.0 : o->ahead, closing = speed - lead;
    if (closing > 0.0) {
        double leaves = crosses ? (corridor + (comes ? beside : -beside)) / sideways : INFINITY;
        if (leaves < larger(room, 0.0) / closing) return unhindered;
        if ((o->along + o->half_along + car->length / 2) / closing < enters) return unhindered;
    }
    double met = closing > 0.0 ? closing * (lead < 0.0 ? speed : closing) : 0.0;
    double needed = met / (2.0 * larger(room - 1.0, 0.1));
    if (needed > 5.0) return -car->brake;
    double wanted = 2.5 + speed * 1.2 + speed * closing / (2.0 * sqrt(2.0 * 2.5));
    double ratio = larger(wanted, 2.5) / larger(room, 0.5), kept = larger(unhindered - 2.0 * (ratio * ratio), -2.5);
    return needed > 2.0 ? smaller(kept, -1.2 * needed) : kept;
}

static void traffic_driver(const Policy *policy, const double *seen, double *acceleration, double *steer) {
    const Limits *car = &policy->car;
    double speed = seen[0], k = scale(speed), wish = smaller(policy->caution.speed, seen[ALLOWED]);
    double ratio = speed / larger(wish, 0.1);
    double a = ratio < 1.0 ? 2.0 * (1.0 - (ratio * ratio) * (ratio * ratio)) : slower(speed, wish);
    Bends bends = bends_of(seen, k);
    for (const double *row = seen + OWN; row < seen + ACTORS_SIZE; row += PER_ACTOR) {
        if (!(row[0] > 0.0)) continue;
        Near o = other(row, k, &bends);
        if (!policy->around && (row[10] > 0.0 || fabs(o.beside) >= 1.75)) continue;
        a = smaller(a, held_back(car, speed, &o, a));
    }
    *acceleration = pressed_at(car, a, speed);
    *steer = steered(car, policy->softness, seen, 0.0);
}

/* chatscene.ego.planner. Who can be near none of the ways at a time is passed over there, since he adds nothing. */
#define STRIDE 0.2

static const double SHIFTS[7] = {0.0, 1.2, -1.2, 2.4, -2.4, 3.6, -3.6};
static const double ACCELERATIONS[7] = {-8.0, -5.0, -3.0, -1.5, 0.0, 1.5, 3.0};

/* That of a way, as far as the body can. */
static double acceleration_of(const Limits *car, int way) {
    return smaller(larger(ACCELERATIONS[way / 7], -car->brake), car->throttle);
}

typedef struct {
    double speed[STEPS][WAYS], gone[STEPS][WAYS], beside[STEPS][WAYS];
    double furthest[STEPS], rightmost[STEPS], leftmost[STEPS]; /* of all ways */
    double scale; /* how many times as far is seen as usual */
} Ways;

static Near along_the_route(const double *seen, const double *row) {
    Near o = {.along = row[1], .beside = row[2], .row = row};
    int at = 0.0 < o.along ? 0 : -1;
    for (int i = 0; i < 5; i++) at += AHEAD[i] < o.along;
    at = at < 0 ? 0 : at > 4 ? 4 : at;
    double before_x = at ? seen[2 + 2 * at] : 0.0, before_y = at ? seen[3 + 2 * at] : 0.0;
    double way = atan2(seen[5 + 2 * at] - before_y, seen[4 + 2 * at] - before_x), ahead = cos(way), left = sin(way);
    o.ahead = row[5] * ahead + row[6] * left;
    o.left = row[6] * ahead - row[5] * left;
    double c = fabs(cos(row[7] - way)), s = fabs(sin(row[7] - way));
    o.speed = hypotenuse(o.ahead, o.left);
    o.half_along = row[8] * c + row[9] * s;
    o.half_beside = row[8] * s + row[9] * c;
    return o;
}

/* The pieces of the route ahead, as straight ones. */
typedef struct {
    double x[5], y[5], cos[5], sin[5], length[5];
} Pieces;

static Pieces pieces_of(const double *seen) {
    Pieces p;
    for (int i = 0; i < 5; i++) {
        p.x[i] = i ? seen[2 + 2 * i] : 0.0;
        p.y[i] = i ? seen[3 + 2 * i] : 0.0;
        double dx = seen[4 + 2 * i] - p.x[i], dy = seen[5 + 2 * i] - p.y[i], way = atan2(dy, dx);
        p.cos[i] = cos(way);
        p.sin[i] = sin(way);
        p.length[i] = i == 4 ? INFINITY : dx * p.cos[i] + dy * p.sin[i];
    }
    return p;
}

/* Where somebody is along the route and beside it who keeps straight in the plane; says at which piece. */
static int straight(const Pieces *p, double k, const double *row, double time, double *along, double *beside) {
    double best = INFINITY, x = row[3] + row[5] * time, y = row[4] + row[6] * time;
    int at = 0;
    for (int i = 0; i < 5; i++) {
        double dx = x - p->x[i], dy = y - p->y[i];
        double ahead = dx * p->cos[i] + dy * p->sin[i], left = dy * p->cos[i] - dx * p->sin[i];
        double foot = smaller(i ? larger(ahead, 0.0) : ahead, p->length[i]), beyond = ahead - foot;
        double away = beyond * beyond + left * left;
        if (away >= best) continue;
        best = away;
        at = i;
        *along = (i ? AHEAD[i - 1] * k : 0.0) + foot;
        *beside = (left < 0.0 ? -1.0 : 1.0) * sqrt(away);
    }
    return at;
}

/* How somebody goes on at a time, as is expected: his speeds. */
static void expected(const Caution *c, const Near *o, int kind, int t, double *ahead, double *left) {
    double time = (t + 1) * STRIDE, fast = o->speed, limit = larger(o->speed, 12.0);
    if (kind == 3) {
        fast = c->stepping * (time > 0.3 ? 1.0 : 0.0);
        *ahead = 0.0 * fast;
        *left = -(double)((o->beside > 0.0) - (o->beside < 0.0)) * fast;
        return;
    }
    if (kind == 1) fast = larger(o->speed - c->braking * time, 0.0);
    else if (kind == 2) fast = smaller(o->speed + c->starting * time, limit);
    *ahead = o->ahead / larger(o->speed, 0.1) * fast;
    *left = o->left / larger(o->speed, 0.1) * fast;
}

/* What an expectation of somebody adds to the danger of each way, and how much of it is not driven then. */
static void endanger(const Policy *policy, const Ways *ways, const Pieces *pieces, const Near *o, int kind,
                     double belief, double offset, double *danger, double *lost) {
    const Limits *car = &policy->car;
    const Caution *c = &policy->caution;
    int swift = policy->swift, crossing = o->speed > 0.5 && fabs(o->left) > 0.5 * o->speed;
    double k = swift ? ways->scale : 1.0;
    double close[WAYS] = {0}, impact[WAYS] = {0}, gone = 0.0, gone_left = 0.0;
    double begun_along, begun_beside, room = 0.0, side = 0.0;
    int first[WAYS];
    for (int w = 0; w < WAYS; w++) first[w] = -1;
    int moves = o->speed > 0.5;
    double along = car->length / 2 + o->half_along, across = car->width / 2 + o->half_beside;
    double near = c->room + 0.5, beside = c->side + c->berth;
    if (kind == 4) straight(pieces, k, o->row, 0.0, &begun_along, &begun_beside);
    for (int t = 0; t < STEPS; t++) {
        double ahead, left, x, y;
        if (kind == 4) {
            const double *row = o->row;
            int at = straight(pieces, k, row, (t + 1) * STRIDE, &x, &y);
            double cs = pieces->cos[at], sn = pieces->sin[at], ct = cos(row[7]), st = sin(row[7]);
            double turned_c = fabs(ct * cs + st * sn), turned_s = fabs(st * cs - ct * sn);
            x = o->along + (x - begun_along);
            y = o->beside + (y - begun_beside);
            ahead = row[5] * cs + row[6] * sn;
            left = row[6] * cs - row[5] * sn;
            along = car->length / 2 + (row[8] * turned_c + row[9] * turned_s);
            across = car->width / 2 + (row[8] * turned_s + row[9] * turned_c);
        } else {
            expected(c, o, kind, t, &ahead, &left);
            gone += ahead;
            gone_left += left;
            x = o->along + gone * STRIDE;
            y = o->beside + gone_left * STRIDE;
        }
        if (!t) { /* who is nearer than we want already is not to stop us from moving away */
            double apart = fabs(o->along) - along, aside = fabs(o->beside - offset) - across;
            room = aside < c->side + 0.2 ? smaller(larger(apart - 0.1, 0.05), c->room) : c->room;
            side = apart < c->room + 0.2 ? smaller(larger(aside - 0.05, 0.05), c->side) : c->side;
        }
        double wide = side + c->widening * ((t + 1) * STRIDE) * (moves ? 1.0 : 0.0);
        double widest = larger(wide, beside), longest = larger(room, near);
        int stays = swift && t == STEPS - 1 && kind == 0 && !crossing;
        if (!stays && (x - ways->furthest[t] - along >= longest || 0.0 - x - along >= longest)) continue;
        if (y - ways->leftmost[t] - across >= widest || ways->rightmost[t] - y - across >= widest) continue;
        for (int w = 0; w < WAYS; w++) {
            double gap = fabs(x - ways->gone[t][w]) - along, berth = fabs(y - ways->beside[t][w]) - across;
            double closing = ways->speed[t][w] - ahead, stops = larger(closing, 0.0), passing = ways->speed[t][w];
            if (swift) passing = fabs(closing) * (1.0 - larger(berth, 0.0) / beside);
            close[w] += (gap < near) & (berth < beside) ? passing : 0.0;
            int meets = gap < room || (stays && x - ways->gone[t][w] > 0.0 && gap < room + (stops * stops) / (2.0 * 4.0));
            if (meets & (berth < wide) & (first[w] < 0)) {
                double dx = ways->speed[t][w] - ahead;
                first[w] = t;
                impact[w] = sqrt(dx * dx + left * left);
            }
        }
    }
    for (int w = 0; w < WAYS; w++) {
        double crash = first[w] < 0 ? 0.0 : c->crash * c->discount[first[w]] * (c->graze + impact[w]);
        if (kind == 0 && first[w] >= 0) lost[w] = larger(lost[w], ways->gone[STEPS - 1][w] - ways->gone[first[w]][w]);
        danger[w] += (crash + c->haste * close[w] * STRIDE) * belief;
    }
}

static double between(double ahead, const double *values) {
    int i = -1;
    for (int k = 0; k < 5; k++) i += AHEAD[k] <= ahead;
    if (i == 4) return values[8];
    return (values[2 * i + 2] - values[2 * i]) / (AHEAD[i + 1] - AHEAD[i]) * (ahead - AHEAD[i]) + values[2 * i];
}

/* How far a way leads to the side, no farther than the driving lanes allow. */
static double shift_of(const Limits *car, const double *seen, int chosen) {
    double left = larger(seen[ACTORS_SIZE] - car->width / 2, 0.0);
    double right = larger(seen[ACTORS_SIZE + 1] - car->width / 2, 0.0);
    return smaller(larger(SHIFTS[chosen % 7], -right), left);
}

/* One step of a way to a shift, no faster than is wished. */
static void carry_out(const Policy *policy, const double *seen, int chosen, double to, double wish,
                      double *acceleration, double *steer) {
    const Limits *car = &policy->car;
    double speed = seen[0], offset = seen[1], a = acceleration_of(car, chosen);
    if (policy->swift) {
        if (a >= 0.0) a = smaller(a, slower(speed, wish));
        *acceleration = pressed_at(car, a, speed);
        *steer = steered(car, policy->softness, seen, to);
        return;
    }
    if (a >= 0.0 && speed >= wish - 0.05) a = larger(-3.0, 2.0 * (wish - speed));
    double shift = offset + larger(-1.6, smaller(1.6, to - offset));
    double look = larger(5.0, 0.9 * speed), way = atan2(seen[7] - seen[5], seen[6] - seen[4]);
    double x = between(look, seen + 4) - sin(way) * shift, y = between(look, seen + 5) + cos(way) * shift;
    double chord2 = x * x + y * y, wheel = atan(car->wheelbase * 2.0 * y / larger(chord2, 1.0));
    *acceleration = within_one(pressed(car, a));
    *steer = within_one(-wheel / car->wheel_angle / 0.3);
}

static double wish_of(const Policy *policy, const double *seen) {
    return smaller(policy->caution.speed, policy->swift ? seen[ALLOWED] : curve_speed(seen));
}

static void planner(const Policy *policy, const double *seen, double *acceleration, double *steer) {
    const Limits *car = &policy->car;
    const Caution *c = &policy->caution;
    int swift = policy->swift;
    double speed = seen[0], offset = seen[1], wish = wish_of(policy, seen), k = swift ? scale(speed) : 1.0;
    double most = larger(wish, speed - 3.0 * STRIDE), cost[WAYS], danger[WAYS] = {0}, lost[WAYS] = {0};
    double able = swift ? able_at(car, speed) : INFINITY, fast = k;
    if (swift)
        for (const double *row = seen + OWN; row < seen + ACTORS_SIZE; row += PER_ACTOR)
            if (row[1] > 0.0 && fabs(row[2]) < 1.75 && row[5] > 0.5) fast = scale(wish);
    double strays = 80.0 * c->astray * (fast - 1.0);
    double gone[WAYS] = {0}, reach[WAYS] = {0}, off[WAYS] = {0}, shift[WAYS];
    for (int w = 0; w < WAYS; w++) shift[w] = shift_of(car, seen, w);
    Ways ways = {.scale = k};
    for (int t = 0; t < STEPS; t++) {
        ways.furthest[t] = ways.leftmost[t] = -INFINITY;
        ways.rightmost[t] = INFINITY;
        for (int w = 0; w < WAYS; w++) {
            double a = smaller(acceleration_of(car, w), able), time = (t + 1) * STRIDE;
            if (swift && a > 0.0) time = STRIDE; /* then it keeps it, until it looks again */
            double v = smaller(larger(speed + time * a, 0.0), most);
            ways.speed[t][w] = v;
            gone[w] += v;
            reach[w] += smaller(c->drift, c->agility * v);
            double far = reach[w] * STRIDE, y = offset + smaller(larger(shift[w] - offset, -far), far);
            ways.gone[t][w] = gone[w] * STRIDE;
            ways.beside[t][w] = y;
            double beside = c->offset * (y * y) + c->astray * larger(fabs(y) - 2.0, 0.0);
            if (swift) beside += strays * larger(fabs(y) - 0.8, 0.0);
            off[w] += beside;
            ways.furthest[t] = larger(ways.furthest[t], ways.gone[t][w]);
            ways.rightmost[t] = smaller(ways.rightmost[t], y);
            ways.leftmost[t] = larger(ways.leftmost[t], y);
        }
    }
    Near near[NEAREST];
    Pieces pieces = pieces_of(seen);
    Bends bends = bends_of(seen, k);
    int count = 0;
    for (const double *row = seen + OWN; row < seen + ACTORS_SIZE; row += PER_ACTOR)
        if (row[0] > 0.0) near[count++] = swift ? other(row, k, &bends) : along_the_route(seen, row);
    for (int kind = 0; kind < 5; kind++) {
        for (int i = 0; i < count; i++) {
            const Near *o = &near[i];
            double moves = o->speed > 0.5 ? 1.0 : 0.0, belief = 1.0;
            double waits = o->speed < 1.5 && fabs(o->beside) > 1.6 && fabs(o->beside) < 8.0 && o->along > -2.0;
            double across = o->speed > 0.5 && fabs(o->left) > 0.5 * o->speed;
            if (kind) belief = kind == 1 ? c->braked * moves : kind == 2 ? c->started * moves : c->stepped * waits;
            if (kind == 4) belief = c->crossing * across;
            if (swift && kind == 3) belief *= o->row[10];
            if (swift && o->ahead > 0.0 && o->along < -(o->half_along + car->length / 2)
                && fabs(o->beside - offset) < o->half_beside + car->width / 2) belief = 0.0; /* he follows */
            if (belief > 0.0) endanger(policy, &ways, &pieces, o, kind, belief, offset, danger, lost);
        }
    }
    int best = 0;
    for (int w = 0; w < WAYS; w++) {
        double a = smaller(acceleration_of(car, w), able);
        cost[w] = c->jerk * (a * a) - ways.gone[STEPS - 1][w] + c->resolve * fabs(shift[w] - offset);
        cost[w] += off[w] * STRIDE;
        if (count) cost[w] += danger[w];
        if (count && swift) cost[w] += lost[w];
        if (cost[w] < cost[best]) best = w;
    }
    carry_out(policy, seen, best, shift[best], wish, acceleration, steer);
}

/* chatscene.ego.network: products added one after the other, in the order of the inputs. Those that are zero are left
 * out, since they add zero; a block of outputs at a time, so that their sums stay at hand. */
#define BLOCK 128
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__)
/* With as wide registers as the machine has. Each sum is of the same products in the same order, none fused. */
#define WIDE __attribute__((target_clones("avx2", "default")))
#define WIDEST __attribute__((target("avx512f")))
#else
#define WIDE
#endif

/* A block of outputs. */
WIDE static void block(const float *columns, int64_t outputs, const float *in, const int32_t *told, int64_t count,
                       float *sum) {
    for (int64_t t = 0; t < count; t++) {
        const float *weight = columns + told[t] * outputs, x = in[told[t]];
        if (t) for (int k = 0; k < BLOCK; k++) sum[k] += weight[k] * x;
        else for (int k = 0; k < BLOCK; k++) sum[k] = weight[k] * x;
    }
}

#ifdef WIDEST
typedef float Wide __attribute__((vector_size(64), aligned(4), may_alias));

/* The same, each sum in a register all along; narrower registers are too few for that. */
WIDEST static void widest_block(const float *columns, int64_t outputs, const float *in, const int32_t *told,
                                int64_t count, float *sum) {
    Wide s0, s1, s2, s3, s4, s5, s6, s7;
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = s7 = (Wide){0};
    for (int64_t t = 0; t < count; t++) {
        const Wide *w = (const Wide *)(columns + told[t] * outputs);
        float x = in[told[t]];
        if (t) {
            s0 += w[0] * x, s1 += w[1] * x, s2 += w[2] * x, s3 += w[3] * x;
            s4 += w[4] * x, s5 += w[5] * x, s6 += w[6] * x, s7 += w[7] * x;
        } else {
            s0 = w[0] * x, s1 = w[1] * x, s2 = w[2] * x, s3 = w[3] * x;
            s4 = w[4] * x, s5 = w[5] * x, s6 = w[6] * x, s7 = w[7] * x;
        }
    }
    Wide *all = (Wide *)sum;
    all[0] = s0, all[1] = s1, all[2] = s2, all[3] = s3, all[4] = s4, all[5] = s5, all[6] = s6, all[7] = s7;
}
#endif

static void summed(const Layer *layer, const float *in, float *out, int32_t *told) {
    int64_t outputs = layer->outputs, count = 0, first = 0;
    for (int32_t i = 0; i < layer->inputs; i++) {
        told[count] = i;
        count += in[i] != 0.0f;
    }
    for (; first + BLOCK <= outputs; first += BLOCK) {
        float sum[BLOCK] = {0};
#ifdef WIDEST
        if (__builtin_cpu_supports("avx512f")) widest_block(layer->columns + first, outputs, in, told, count, sum);
        else
#endif
            block(layer->columns + first, outputs, in, told, count, sum);
        for (int k = 0; k < BLOCK; k++) out[first + k] = sum[k] + layer->bias[first + k];
    }
    for (; first < outputs; first += 2) { /* two at a time, so that neither waits for the other */
        int64_t next = first + 1 < outputs ? 1 : 0;
        const float *columns = layer->columns + first;
        float one = 0.0f, other = 0.0f;
        for (int64_t t = 0; t < count; t++) {
            const float *weight = columns + told[t] * outputs, x = in[told[t]];
            one = t ? one + weight[0] * x : weight[0] * x;
            other = t ? other + weight[next] * x : weight[next] * x;
        }
        out[first + next] = other + layer->bias[first + next];
        out[first] = one + layer->bias[first];
    }
}

static double squashed(double value, int32_t output) {
    if (output == BY_TANH) value = tanh(value);
    else if (output == BY_SIGMOID) value = tanh(0.5 * value);
    return six_decimals(within_one(value));
}

static void network(const Policy *policy, const double *seen, double *acceleration, double *steer) {
    float *in = policy->one, *out = policy->other;
    for (int64_t i = 0; i < policy->layer[0].inputs; i++) in[i] = (float)seen[i];
    float at_most = (float)policy->caution.speed;
    if (policy->swift && at_most > 0.0f && in[ALLOWED] > at_most) in[ALLOWED] = at_most;
    for (int64_t l = 0; l < policy->layers; l++) {
        const Layer *layer = &policy->layer[l];
        if (l && policy->hidden == RELU) for (int64_t i = 0; i < layer->inputs; i++) in[i] = in[i] <= 0.0f ? 0.0f : in[i];
        else if (l) for (int64_t i = 0; i < layer->inputs; i++) in[i] = (float)tanh(in[i]);
        summed(layer, in, out, policy->told);
        float *swapped = in;
        in = out;
        out = swapped;
    }
    if (policy->output == BY_WAY) {
        int chosen = 0;
        for (int way = 1; way < WAYS; way++) if (in[way] > in[chosen]) chosen = way;
        double to = policy->layer[0].inputs >= ROAD_SIZE ? shift_of(&policy->car, seen, chosen) : SHIFTS[chosen % 7];
        carry_out(policy, seen, chosen, to, wish_of(policy, seen), acceleration, steer);
        return;
    }
    *acceleration = squashed(in[0], policy->output);
    *steer = squashed(in[1], policy->output);
}

/* What somebody does who sees this. */
void ask(const Policy *policy, const double *seen, double *acceleration, double *steer) {
    switch (policy->kind) {
    case RULE_BASED: rule_based(policy->caution.speed, seen, acceleration, steer); break;
    case INTELLIGENT_DRIVER:
        intelligent_driver(&policy->car, policy->caution.speed, seen, acceleration, steer);
        break;
    case PLANNER: planner(policy, seen, acceleration, steer); break;
    case TRAFFIC_DRIVER: traffic_driver(policy, seen, acceleration, steer); break;
    default: network(policy, seen, acceleration, steer);
    }
}

/* The same at a step of a drive. A network that sees there what it last saw there answers as it did: the drives of a
 * route begin alike, and one that is driven again to brake goes on alike until then. */
static void ask_at(const Policy *policy, int64_t step, const double *seen, double *acceleration, double *steer) {
    if (policy->kind != NETWORK || step >= policy->remembers) { ask(policy, seen, acceleration, steer); return; }
    int64_t size = policy->layer[0].inputs;
    double *row = policy->memory + step * (size + 3);
    if (memcmp(row, seen, sizeof(double) * (size_t)size) || row[size] != policy->caution.speed) {
        ask(policy, seen, row + size + 1, row + size + 2);
        memcpy(row, seen, sizeof(double) * (size_t)size);
        row[size] = policy->caution.speed;
    }
    *acceleration = row[size + 1];
    *steer = row[size + 2];
}

/* What the ego sees where it is, which may be anywhere on its route. */
void see_world(World *w) {
    locate(w);
    see(w);
}

/* Runs a world to its end, or to a step; how many steps it took. */
int64_t run_world(World *w, const Policy *policy, int64_t until) {
    int64_t first = w->step, left = 0;
    double acceleration = 0.0, steer = 0.0;
    see_world(w);
    while (w->ending == GOES_ON && !w->fault && w->step < until) {
        if (!left) { left = policy->every; ask_at(policy, w->step, w->seen, &acceleration, &steer); }
        left--;
        press(w, acceleration, steer);
    }
    return w->step - first;
}

/* Runs a world with somebody else's foot on the brake (chatscene.measure.avoidability), to its end or until the ego has
 * stood long enough. */
void brake_world(World *w, const Policy *policy, const Foot *foot) {
    int64_t left = 0, standing = 0;
    double acceleration = 0.0, steer = 0.0;
    see_world(w);
    while (w->ending == GOES_ON && !w->fault && (double)standing * w->dt < foot->standstill) {
        if (!left) { left = policy->every; ask_at(policy, w->step, w->seen, &acceleration, &steer); }
        left--;
        double pressed = acceleration < 0.0 ? acceleration * foot->own : acceleration;
        if (w->step >= foot->begins) {
            double share = (double)(w->step - foot->begins + 1) * w->dt / foot->ramp;
            double wish = foot->full * (share < 1.0 ? share : 1.0) - foot->car.drag;
            double braked = -(wish > 0.0 ? wish : 0.0) / foot->car.brake;
            pressed = braked < pressed ? braked : pressed;
        }
        press(w, pressed, steer);
        standing = w->step > foot->over && fabs(w->body[0].speed) < foot->standing ? standing + 1 : 0;
    }
}

/* Runs many worlds, one after the other; how many steps they took together. */
int64_t run_worlds(World *const *worlds, int64_t count, const Policy *policy) {
    int64_t steps = 0;
    for (int64_t i = 0; i < count; i++) steps += run_world(worlds[i], policy, INT64_MAX);
    return steps;
}

/* Judging: the boxes of two bodies over time. `chatscene.simulate.boxes` has each of these in Python, too, for machines
 * without this engine. Sines and cosines are given, since numpy has its own. A comparison with what is no number is
 * false, and the less and the greater of it are no number, as numpy has them. */
static double lesser(double a, double b) { return a < b || isnan(a) ? a : b; }
static double greater(double a, double b) { return a > b || isnan(a) ? a : b; }

typedef struct {
    double axis_x[4], axis_y[4], offset[4], reach[4], c, s;
} Apart;

/* `Pair.of` of the first at one moment and the second at another */
static void apart_at(const Boxes *a, int64_t i, const Boxes *b, int64_t j, Apart *p) {
    double ac = a->cos[i], as = a->sin[i], bc = b->cos[j], bs = b->sin[j];
    double dx = b->x[j] - a->x[i], dy = b->y[j] - a->y[i];
    double c, s;
    p->c = ac * bc + as * bs;
    c = fabs(p->c);
    s = p->s = fabs(ac * bs - as * bc);
    p->axis_x[0] = ac; p->axis_x[1] = -as; p->axis_x[2] = bc; p->axis_x[3] = -bs;
    p->axis_y[0] = as; p->axis_y[1] = ac; p->axis_y[2] = bs; p->axis_y[3] = bc;
    p->reach[0] = a->half_length + b->half_length * c + b->half_width * s;
    p->reach[1] = a->half_width + b->half_length * s + b->half_width * c;
    p->reach[2] = b->half_length + a->half_length * c + a->half_width * s;
    p->reach[3] = b->half_width + a->half_length * s + a->half_width * c;
    for (int k = 0; k < 4; k++) p->offset[k] = dx * p->axis_x[k] + dy * p->axis_y[k];
}

static int overlapping(const Apart *p) {
    for (int k = 0; k < 4; k++) if (!(fabs(p->offset[k]) <= p->reach[k])) return 0;
    return 1;
}

static double corner_gap(const Boxes *a, const Boxes *b, int64_t i) {
    static const double AHEAD_BY[] = {1.0, 1.0, -1.0, -1.0}, LEFT_BY[] = {1.0, -1.0, -1.0, 1.0};
    double least = INFINITY, ac = a->cos[i], as = a->sin[i], bc = b->cos[i], bs = b->sin[i];
    for (int k = 0; k < 4; k++) {
        double along = a->half_length * AHEAD_BY[k], across = a->half_width * LEFT_BY[k];
        double dx = a->x[i] + along * ac - across * as - b->x[i], dy = a->y[i] + along * as + across * ac - b->y[i];
        double beyond_x = greater(fabs(dx * bc + dy * bs) - b->half_length, 0.0);
        double beyond_y = greater(fabs(dy * bc - dx * bs) - b->half_width, 0.0);
        if (beyond_x * beyond_x + beyond_y * beyond_y > least * least * (1.0 + 1e-9)) continue; /* it is farther */
        least = lesser(beyond_x == 0.0 ? beyond_y : beyond_y == 0.0 ? beyond_x : hypot(beyond_x, beyond_y), least);
    }
    return least;
}

/* `Pair.overlap`: from when to when the boxes overlap on all axes, the second moving past the first */
static void meet(const Apart *p, double vx, double vy, double *from, double *until) {
    double begin = -INFINITY, end = INFINITY;
    for (int k = 0; k < 4; k++) {
        double speed = vx * p->axis_x[k] + vy * p->axis_y[k], offset = p->offset[k], reach = p->reach[k];
        if (fabs(speed) < 1e-9) {
            begin = greater(fabs(offset) <= reach ? -INFINITY : INFINITY, begin);
            continue;
        }
        double first = (-reach - offset) / speed, last = (reach - offset) / speed;
        begin = greater(lesser(first, last), begin);
        end = lesser(greater(first, last), end);
    }
    *from = begin;
    *until = end;
}

static double time_to_collision(const Apart *p, double vx, double vy) {
    double begin, end;
    meet(p, vx, vy, &begin, &end);
    return begin <= end && end >= 0.0 ? greater(begin, 0.0) : INFINITY;
}

/* `boxes._beyond_corner` */
static double beyond_corner(const Boxes *a, const Boxes *b, double across, double c, double s) {
    int alike = (c < 0.0) == (s < 0.0);
    c = fabs(c);
    s = fabs(s);
    double offset = b->half_width * c - b->half_length * s;
    double corner = across + (alike ? offset : -offset), out = fabs(corner) - a->half_width;
    if (!(out > 0.0)) return 0.0;
    int is_short = (corner > 0.0) == alike;
    double deep = 2.0 * (is_short ? b->half_width * s : b->half_length * c);
    double wide = 2.0 * (is_short ? b->half_width * c : b->half_length * s);
    return deep * (wide > out ? out / wide : 1.0);
}

/* `boxes.between`: how two bodies lie to each other at each step; `ahead` is -inf where the second is not ahead. */
void compare_boxes(int64_t steps, const Boxes *a, const double *speed, const Boxes *b, const double *other, double *found) {
    double *gaps = found, *times = gaps + steps, *ahead = times + steps, *closing = ahead + steps;
    for (int64_t i = 0; i < steps; i++) {
        Apart p;
        apart_at(a, i, b, i, &p);
        gaps[i] = overlapping(&p) ? 0.0 : lesser(corner_gap(a, b, i), corner_gap(b, a, i));
        times[i] = time_to_collision(
            &p, other[i] * b->cos[i] - speed[i] * a->cos[i], other[i] * b->sin[i] - speed[i] * a->sin[i]);
        double turned = a->cos[i] * b->sin[i] - a->sin[i] * b->cos[i];
        double gap = p.offset[0] - a->half_length - b->half_length * fabs(p.c) - b->half_width * p.s
            + beyond_corner(a, b, p.offset[1], p.c, turned);
        double beside = fabs(p.offset[1]) - a->half_width - b->half_length * p.s - b->half_width * fabs(p.c);
        ahead[i] = gap > 0.0 && beside < 0.0 ? gap : -INFINITY;
        closing[i] = speed[i] - other[i] * p.c;
    }
}

/* Where the places of each row are, in parts of so many: least and greatest x, least and greatest y of a part. */
static double *extents_of(int64_t rows, int64_t width, const Boxes *a) {
    int64_t parts = (width + PART - 1) / PART;
    double *extents = malloc(sizeof(double) * 4 * (size_t)(rows * parts + 1));
    for (int64_t part = 0; extents && part < rows * parts; part++) {
        double *e = extents + 4 * part;
        e[0] = e[2] = INFINITY;
        e[1] = e[3] = -INFINITY;
        int64_t first = part % parts * PART, row = part / parts * width;
        for (int64_t step = first; step < first + PART && step < width; step++) {
            double x = a->x[row + step], y = a->y[row + step];
            if (x < e[0]) e[0] = x;
            if (x > e[1]) e[1] = x;
            if (y < e[2]) e[2] = y;
            if (y > e[3]) e[3] = y;
        }
    }
    return extents;
}

/* `boxes.overlaps`: at which moments of the first, in rows of so many, and of the second boxes overlap, of those
 * nearest to the same moment and one step farther; how many there are. */
int64_t overlaps(int64_t rows, int64_t width, const Boxes *a, int64_t count, const Boxes *b, const int64_t *at,
                 int64_t most, double square, int64_t *first, int64_t *second) {
    int64_t least = most, found = 0, any = 0, parts = (width + PART - 1) / PART;
    double *extents = extents_of(rows, width, a);
    for (int pass = 0; pass < 2 && (!pass || any); pass++) {
        int64_t lags = pass ? least + 1 < most ? least + 1 : most : least;
        for (int64_t row = 0; row < rows; row++) {
            for (int64_t j = 0; j < count; j++) {
                double x = b->x[j], y = b->y[j];
                if (!pass) lags = any ? least - 1 : most; /* the others are no nearer */
                int64_t low = at[j] - lags, high = at[j] + lags;
                for (int64_t step = low < 0 ? 0 : low; step <= high && step < width; step++) {
                    int64_t i = row * width + step;
                    int begins = step % PART == 0 || step == low || step == 0;
                    if (begins && extents && far_from(extents + 4 * (row * parts + step / PART), x, y, square)) {
                        step = step / PART * PART + PART - 1;
                        continue;
                    }
                    double dx = a->x[i] - x, dy = a->y[i] - y;
                    if (!(dx * dx + dy * dy <= square)) continue;
                    Apart p;
                    apart_at(a, i, b, j, &p);
                    if (!overlapping(&p)) continue;
                    int64_t lag = step < at[j] ? at[j] - step : step - at[j];
                    if (pass) { first[found] = i; second[found++] = j; continue; }
                    if (!any || lag < least) { any = 1; least = lag; }
                }
            }
        }
    }
    free(extents);
    return found;
}

/* Which of some points lie nearer to any of others than the root of `square`. */
void near_any(int64_t count, const double *x, const double *y, int64_t others, const double *other_x,
              const double *other_y, double square, uint8_t *near) {
    for (int64_t i = 0; i < count; i++) {
        near[i] = 0;
        for (int64_t k = 0; k < others && !near[i]; k++) {
            double dx = x[i] - other_x[k], dy = y[i] - other_y[k];
            near[i] = dx * dx + dy * dy < square;
        }
    }
}

/* `measure.criticality`: of what `compare_boxes` found, the least gap and its step, the least time to collision, the
 * least headway of a first that is faster than `crawl`, and the hardest braking that keeps it from the second ahead. */
void closest(int64_t steps, const double *found, const double *speed, double crawl, double *told) {
    const double *gaps = found, *times = gaps + steps, *ahead = times + steps, *closing = ahead + steps;
    double gap = INFINITY, nearest = 0.0, time = INFINITY, headway = INFINITY, braking = 0.0;
    for (int64_t i = 0; i < steps; i++) {
        double now = lesser(gaps[i], gap);
        if (now != gap && !isnan(gap)) nearest = (double)i;
        gap = now;
        if (times[i] < time) time = times[i];
        if (!(ahead[i] > 0.0)) continue;
        double needs = closing[i] > 1e-9 ? closing[i] * closing[i] / (2.0 * ahead[i]) : 0.0;
        if (needs > braking) braking = needs;
        if (speed[i] > crawl && ahead[i] / speed[i] < headway) headway = ahead[i] / speed[i];
    }
    told[0] = gap; told[1] = nearest; told[2] = time; told[3] = headway; told[4] = braking;
}

/* `boxes.post_encroachment`: of pairs of overlapping boxes, each a step of the first and one of the second, the least
 * time between the two. `a` is the first within its step, in so many parts; the second moves on evenly in its own. */
static double parted(int64_t pairs, const int64_t *i, const int64_t *j, int64_t parts, const Boxes *a, const Boxes *b) {
    double least = INFINITY;
    for (int64_t n = 0; n < pairs; n++) {
        int64_t apart = i[n] > j[n] ? i[n] - j[n] : j[n] - i[n];
        if ((double)apart < least) least = (double)apart;
    }
    for (int64_t n = 0; n < pairs; n++) {
        int64_t apart = i[n] > j[n] ? i[n] - j[n] : j[n] - i[n], back = j[n] > i[n] ? j[n] - 1 : j[n] + 1;
        double vx = b->x[back] - b->x[j[n]], vy = b->y[back] - b->y[j[n]];
        for (int64_t part = 0; part <= parts; part++) {
            double begin, end;
            Apart p;
            apart_at(a, part * pairs + n, b, j[n], &p);
            meet(&p, vx, vy, &begin, &end);
            if (!(begin <= end && begin <= 1.0 && end >= 0.0)) continue;
            double closest = (double)apart - (double)part / (double)parts - lesser(end, 1.0);
            if (closest < least) least = closest;
        }
    }
    return least > 0.0 ? least : 0.0;
}

/* What `boxes.post_encroachment` asks of the engine first: the pairs of moments at which one is where the other is,
 * nearest in time, and where the first is at parts of its step on the way to the other moment. `at` has room for a number
 * of each step, `first` and `second` for four, and each of `moments` for 4 * (parts + 1). Returns how many pairs there
 * are; -1 if two moments are the same. */
static int64_t shared_places(int64_t steps, const Boxes *a, const double *heading, const Boxes *b, double square,
                             int64_t parts, int64_t *at, int64_t *first, int64_t *second, double *moments[3]) {
    for (int64_t i = 0; i < steps; i++) at[i] = i;
    int64_t count = overlaps(1, steps, a, steps, b, at, steps, square, first, second);
    for (int64_t n = 0; n < count; n++) if (first[n] == second[n]) return -1;
    const double *columns[3] = {a->x, a->y, heading};
    for (int64_t part = 0; part <= parts; part++) {
        for (int64_t n = 0; n < count; n++) {
            int64_t toward = second[n] > first[n] ? 1 : -1;
            double moment = (double)(first[n] * parts + toward * part) / (double)parts;
            int64_t before = (int64_t)moment;
            for (int k = 0; k < 3; k++) {
                double now = columns[k][before];
                if ((double)before != moment) now = (columns[k][before + 1] - now) * (moment - (double)before) + now;
                moments[k][part * count + n] = now;
            }
        }
    }
    return count;
}

/* `measure.avoidability.risk_step`: the first of so many steps in a row from each of which the ego, going on along its
 * course, and the other, going straight on, will touch, where it is seen; -1 if there are none. */
int64_t first_risk(int64_t steps, int64_t moments, const double *ahead, const Course *course, const double *along,
                   const double *speed, double half_length, double half_width, const Boxes *b, const double *other,
                   const uint8_t *seen, int64_t lasting) {
    int64_t last = course->points - 1, row = 0;
    double reach = sqrt(half_length * half_length + half_width * half_width)
        + sqrt(b->half_length * b->half_length + b->half_width * b->half_width) + 1e-6;
    for (int64_t i = 0; i < steps; i++) {
        int touches = 0;
        int64_t k = 0;
        double goes = speed[i] > 0.0 ? speed[i] : 0.0, vx = other[i] * b->cos[i], vy = other[i] * b->sin[i];
        for (int64_t m = 0; seen[i] && !touches && m < moments; m++) {
            double stop = along[i] + goes * ahead[m], x, y;
            if (!m) {
                int64_t low = 0, high = last + 1; /* the first point that lies beyond */
                while (low < high) {
                    int64_t middle = (low + high) / 2;
                    if (course->arc[middle] <= stop) low = middle + 1; else high = middle;
                }
                k = low - 1;
            }
            while (k < last && course->arc[k + 1] <= stop) k++;
            if (k < 0 || k >= last || course->arc[k] == stop) {
                x = course->x[k < 0 ? 0 : k];
                y = course->y[k < 0 ? 0 : k];
            } else {
                x = course->x_rate[k] * (stop - course->arc[k]) + course->x[k];
                y = course->y_rate[k] * (stop - course->arc[k]) + course->y[k];
            }
            int64_t piece = k < 0 ? 0 : k >= last ? last - 1 : k;
            double beyond = stop - course->arc[last] > 0.0 ? stop - course->arc[last] : 0.0;
            double ca = course->cos[piece], sa = course->sin[piece], cb = b->cos[i], sb = b->sin[i];
            double dx = b->x[i] + vx * ahead[m] - (x + beyond * ca), dy = b->y[i] + vy * ahead[m] - (y + beyond * sa);
            if (dx * dx + dy * dy > reach * reach) continue;
            double c = fabs(ca * cb + sa * sb), s = fabs(ca * sb - sa * cb);
            touches = fabs(dx * ca + dy * sa) <= half_length + b->half_length * c + b->half_width * s
                && fabs(dy * ca - dx * sa) <= half_width + b->half_length * s + b->half_width * c
                && fabs(dx * cb + dy * sb) <= b->half_length + half_length * c + half_width * s
                && fabs(dy * cb - dx * sb) <= b->half_width + half_length * s + half_width * c;
        }
        row = touches ? row + 1 : 0;
        if (row == lasting) return i - lasting + 1;
    }
    return -1;
}

/* `measure.speeds`: when the last braking of either begins before the last step, and how fast both were: at that step,
 * at most, and how much speed each lost at most over a step. A braking that is over for longer than `pause` was another,
 * unless both go the same way and the first gained less than `gains` since. `room` is for three numbers of each step. */
static int64_t braking_begins(int64_t steps, const double *speed, const double *other, double least, double still,
                       int64_t pause, int32_t same_way, double gains, double *room, double *told) {
    double *fast[2] = {room, room + steps}, *reacts = room + 2 * steps;
    for (int64_t i = 0; i < steps; i++) reacts[i] = 0.0;
    for (int who = 0; who < 2; who++) {
        double most = 0.0, hardest = 0.0;
        for (int64_t i = 0; i < steps; i++) {
            double now = fast[who][i] = fabs(who ? other[i] : speed[i]), change = i ? now - fast[who][i - 1] : 0.0;
            if (now > most) most = now;
            if (change < hardest) hardest = change;
            if (-change > least || (now < still && most >= still)) reacts[i] = 1.0;
        }
        told[2 + who] = most;
        told[4 + who] = fabs(hardest);
    }
    int64_t begins = steps - 1, last = steps - 1;
    for (int64_t step = steps - 1; step >= 0; step--) {
        if (reacts[step] == 0.0) continue;
        double peak = 0.0;
        for (int64_t i = step; i <= last; i++) if (fast[0][i] > peak) peak = fast[0][i];
        if (last - step > pause && !(same_way && peak - fast[0][step] < gains)) break;
        begins = step ? step - 1 : 0;
        last = step;
    }
    told[0] = fast[0][begins];
    told[1] = fast[1][begins];
    return begins;
}

/* `measure.tyres`: the most that tyres did along and across together over a step, -1 without a step; and whether they
 * did more than `across` in one that was faster than `fast`. */
static double tyres_did(int64_t steps, const double *speed, const double *heading, double dt, double rolling, double air,
                 double across, double fast, int32_t *beyond) {
    double most = -1.0;
    *beyond = 0;
    for (int64_t i = 0; i + 1 < steps; i++) {
        double from = fabs(speed[i]), to = fabs(speed[i + 1]), change = (to - from) / dt, mean = 0.5 * (to + from);
        double held = change + rolling + air * (from * from), turned = mean * (heading[i + 1] - heading[i]) / dt;
        double did = hypot(change < 0.0 ? (held < 0.0 ? held : 0.0) : change, turned);
        if (did > most) most = did;
        if (fabs(turned) > across && mean > fast) *beyond = 1;
    }
    return most;
}

/* Which cell of a map each of some points lies in, and what is known of that: 0 of one that nobody asked of yet. Of
 * points beside the map it is -1. Returns how many are of neither. */
int64_t in_cells(int64_t count, const double *x, const double *y, double low_x, double low_y, double side, int64_t wide,
                 int64_t high, const int32_t *known, int32_t *found) {
    int64_t told = 0;
    for (int64_t i = 0; i < count; i++) {
        double column = floor((x[i] - low_x) / side), row = floor((y[i] - low_y) / side);
        int there = column >= 0.0 && column < (double)wide && row >= 0.0 && row < (double)high;
        found[i] = there ? known[(int64_t)row * wide + (int64_t)column] : -1;
        told += found[i] > 0;
    }
    return told;
}

/* `simulate.cells.Cells.along`, of a lane, -1 for none, and whether that is off the road, as (lane + 2) * 2 + off: in
 * `found`, how many steps begin to be off the road and how many come before another lane, and which each of them are. */
void lane_events(int64_t steps, const int32_t *codes, uint8_t *off, int64_t *found) {
    int64_t onsets = 0, changes = 0, *changed = found + 2 + steps;
    for (int64_t i = 0; i < steps; i++) {
        off[i] = codes[i] & 1;
        if (off[i] && (!i || !off[i - 1])) found[2 + onsets++] = i;
        if (i + 1 < steps && codes[i] >> 1 >= 2 && codes[i] >> 1 != codes[i + 1] >> 1) changed[changes++] = i;
    }
    found[0] = onsets; found[1] = changes;
}

static int64_t crosses(int64_t steps, const double *x, const double *y, double x0, double y0, double x1, double y1) {
    double lx = x1 - x0, ly = y1 - y0;
    for (int64_t i = 0; i + 1 < steps; i++) {
        double px = x[i] - x0, py = y[i] - y0, qx = x[i + 1] - x0, qy = y[i + 1] - y0;
        double side = lx * py - ly * px, next = lx * qy - ly * qx;
        if (!(side * next < 0.0)) continue;
        double share = side / (side - next);
        double along = ((px + share * (qx - px)) * lx + (py + share * (qy - py)) * ly) / (lx * lx + ly * ly);
        if (-0.1 <= along && along <= 1.1) return i + 1;
    }
    return -1;
}

/* `simulate.roadside.crossing_steps`: the first step at which a track crosses each of some lines, of x, y of one end and
 * of the other; -1 if it never does. */
void cross(int64_t steps, const double *x, const double *y, int64_t count, const double *lines, int64_t *found) {
    for (int64_t k = 0; k < count; k++) {
        const double *line = lines + 4 * k;
        found[k] = crosses(steps, x, y, line[0], line[1], line[2], line[3]);
    }
}

/* By how much something rises at most in so many steps, and the step at which it has. */
static void most_in(int64_t steps, const double *values, double sign, int64_t within, double *told) {
    told[0] = 0.0;
    told[1] = (double)(steps - 1);
    for (int64_t i = within; i < steps; i++) {
        double change = sign * fabs(values[i]) - sign * fabs(values[i - within]);
        if (i > within && !(change > told[0])) continue;
        told[0] = change;
        told[1] = (double)i;
    }
}

/* CARLA's yaw of a heading (`measure.score`): degrees in single precision, clockwise, in (-180, 180]; in radians. */
static double reference_yaw(double heading) {
    float turned = (float)(heading * (180.0 / PI)) + 180.0f, rest = fmodf(turned, 360.0f);
    if (rest < 0.0f) rest += 360.0f;
    else if (rest == 0.0f) rest = 0.0f;
    return (double)(180.0f - rest) * (PI / 180.0);
}

/* Every number that `chatscene.measure` takes from the tracks of a drive; `measure.sums` has what each is. Of each of
 * `tracks`, the ego's first: `states`, its x, y, heading and speed at each step; `cos` and `sin` of the heading; `who`,
 * half its length and width, 1 for an adversary, and what rolls off its speed, not a number of who has no wheels. */
static void sum_up_one(int64_t steps, int64_t longest, int64_t tracks, int64_t crash, int64_t struck, int64_t rows,
                       const double *states, const double *cosines, const double *sines, const double *who,
                       const double *aside, const Habits *h, double *found, double *room, double *told, double *all,
                       double *paces) {
    Boxes ego = {states, states + longest, cosines, sines, who[0], who[1]};
    const double *speed = states + 3 * longest, *heading = states + 2 * longest;
    double *apart = room + 3 * steps, *seconds = apart + steps, least = INFINITY;
    int64_t meets = struck, adversary = 0, until = crash < 0 || crash > steps ? steps : crash > 1 ? crash : 1;
    int64_t pace = steps - 1;
    for (int64_t i = 0; i < steps; i++) apart[i] = seconds[i] = INFINITY;
    for (int64_t k = 0; k < tracks; k++) {
        const double *state = states + 4 * k * longest, *w = who + 4 * k;
        double *t = told + 8 * k;
        int32_t beyond = 0;
        t[5] = -1.0;
        if (!isnan(w[3])) {
            t[5] = tyres_did(until, state + 3 * longest, state + 2 * longest, h->dt, w[3], h->air, h->across, h->fast, &beyond);
        }
        t[6] = beyond;
        if (w[2] == 0.0) continue;
        Boxes other = {state, state + longest, cosines + k * longest, sines + k * longest, w[0], w[1]};
        double *f = found + 4 * steps * adversary++, *ahead = f + 2 * steps, *closing = f + 3 * steps;
        compare_boxes(steps, &ego, speed, &other, state + 3 * longest, f);
        closest(steps, f, speed, h->crawl, t);
        if (crash < 0 && t[0] < least) { least = t[0]; meets = k; }
        int64_t not_ahead = -h->lately - 1;
        for (int64_t i = 0; i < steps; i++) {
            if (f[i] < apart[i]) apart[i] = f[i];
            if (f[steps + i] < seconds[i]) seconds[i] = f[steps + i];
            if (!(ahead[i] > 0.0)) { not_ahead = i; continue; }
            if (!(speed[i] > h->crawl && (closing[i] > h->crawl || i - not_ahead <= h->lately))) continue;
            if (ahead[i] / speed[i] < seconds[i]) seconds[i] = ahead[i] / speed[i];
        }
    }
    double near = INFINITY;
    int64_t soonest = 0, nearest = 0;
    for (int64_t i = 0; i < steps; i++) {
        if (apart[i] < near) near = apart[i];
        if (seconds[i] < seconds[soonest]) soonest = i;
    }
    for (int64_t i = 0; i < steps; i++) if (apart[i] <= near + h->as_near) nearest = i;
    all[0] = near; all[1] = (double)nearest; all[2] = seconds[soonest]; all[3] = (double)soonest;
    most_in(steps, speed, -1.0, h->over, all + 4);
    most_in(steps, aside, 1.0, h->within, all + 6);
    all[8] = (double)meets;
    for (int k = 9; k < 16; k++) all[k] = 0.0;
    if (meets >= 0) {
        const double *state = states + 4 * meets * longest;
        int64_t last = crash < 0 ? (int64_t)told[8 * meets + 1] : until > 1 ? until - 1 : 0;
        int32_t same_way = cos(state[2 * longest + last] - heading[last]) > h->same_way;
        all[9] = (double)braking_begins(last + 1, speed, state + 3 * longest, h->reacts, h->still, h->pause, same_way,
                                        h->gains, room, all + 10);
    }
    for (int64_t i = 0; i < pace; i++) {
        double vx = speed[i + 1] * cosines[i + 1] - speed[i] * cosines[i];
        double vy = speed[i + 1] * sines[i + 1] - speed[i] * sines[i];
        paces[i] = hypot(vx, vy);
        paces[longest + i] = fabs(reference_yaw(heading[i + 1]) - reference_yaw(heading[i]));
        paces[2 * longest + i] = fabs(heading[i + 1] - heading[i]);
    }
    /* Whether the ego stands at the end, and somebody who stands as well is as near as one who waits for him. */
    int64_t since = rows < steps ? steps - rows : 0;
    all[16] = 0.0;
    for (int64_t k = 0; crash < 0 && k < tracks; k++) {
        const double *state = states + 4 * k * longest;
        int stands = 1;
        for (int64_t i = steps - 1; i >= since && stands; i--) stands = fabs(state[3 * longest + i]) < h->standing;
        if (!k && !stands) break;
        if (!k || !stands) continue;
        Boxes other = {state, state + longest, cosines + k * longest, sines + k * longest, who[4 * k], who[4 * k + 1]};
        for (int64_t i = steps - 1; i >= since && all[16] == 0.0; i--) {
            Apart p;
            apart_at(&ego, i, &other, i, &p);
            double gap = overlapping(&p) ? 0.0 : lesser(corner_gap(&ego, &other, i), corner_gap(&other, &ego, i));
            if (gap < h->behind) all[16] = 1.0;
        }
    }
}

/* The numbers of a block of drives. `states` are of so many scenes, road users, columns and steps, the others alike.
 * `about` has of each scene how many steps and road users it has, at which step the ego collides first and with whom,
 * -1 without one, and in how many rows at its end one stands who waits. `room` is for 5 numbers of each of the longest
 * drive's steps and 4 more for each road user, `paces` for 3 of each scene. Of two who come to the same places, `counts` has where their
 * pairs of moments begin and how many there are (`shared_places`). Returns how many there are in all. */
int64_t sum_up(int64_t scenes, int64_t actors, int64_t longest, int64_t parts, const int64_t *about, const double *states,
               const double *cosines, const double *sines, const double *who, const double *aside, const Habits *h,
               double *room, double *told, double *all, double *paces, int64_t *counts, int64_t *first, int64_t *second,
               double *x, double *y, double *turned) {
    int64_t begin = 0;
    for (int64_t s = 0; s < scenes; s++) {
        int64_t steps = about[5 * s], tracks = about[5 * s + 1], struck = about[5 * s + 3];
        const double *state = states + 4 * s * actors * longest, *w = who + 4 * s * actors;
        const double *c = cosines + s * actors * longest, *z = sines + s * actors * longest;
        Boxes ego = {state, state + longest, c, z, w[0], w[1]};
        sum_up_one(steps, longest, tracks, about[5 * s + 2], struck, about[5 * s + 4], state, c, z, w, aside + s * longest,
                   h, room + 5 * longest, room, told + 8 * s * actors, all + 17 * s, paces + 3 * s * longest);
        int met = struck >= 0 && w[4 * struck + 2] != 0.0;
        for (int64_t k = 0; k < actors; k++) {
            int64_t *count = counts + 2 * (s * actors + k);
            const double *of = w + 4 * k, *at = state + 4 * k * longest;
            count[0] = begin;
            count[1] = 0;
            if (k >= tracks || of[2] == 0.0 || met) continue;
            Boxes other = {at, at + longest, c + k * longest, z + k * longest, of[0], of[1]};
            double reach = hypotenuse(w[0], w[1]) + hypotenuse(of[0], of[1]) + 1e-6;
            double *moments[3] = {x + begin * (parts + 1), y + begin * (parts + 1), turned + begin * (parts + 1)};
            count[1] = shared_places(steps, &ego, state + 2 * longest, &other, reach * reach, parts, (int64_t *)room,
                                     first + begin, second + begin, moments);
            if (count[1] > 0) begin += count[1];
        }
    }
    return begin;
}

/* Of each of those pairs the least time [steps] between one leaving a place and the other coming to it: inf without such
 * places, 0 where both are at one at the same time. Cosines and sines of `turned` are given. */
void part(int64_t scenes, int64_t actors, int64_t longest, int64_t parts, const double *states, const double *cosines,
          const double *sines, const double *who, const int64_t *counts, const int64_t *first, const int64_t *second,
          const double *x, const double *y, const double *cosine, const double *sine, double *least) {
    for (int64_t pair = 0; pair < scenes * actors; pair++) {
        int64_t count = counts[2 * pair + 1], at = counts[2 * pair], from = at * (parts + 1);
        const double *state = states + 4 * pair * longest, *ego = who + 4 * (pair / actors * actors), *w = who + 4 * pair;
        Boxes mine = {x + from, y + from, cosine + from, sine + from, ego[0], ego[1]};
        Boxes other = {state, state + longest, cosines + pair * longest, sines + pair * longest, w[0], w[1]};
        least[pair] = count < 0 ? 0.0 : count ? parted(count, first + at, second + at, parts, &mine, &other) : INFINITY;
    }
}
