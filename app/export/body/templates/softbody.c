// GIVEN_ABOUT
#include "softbody.h"

#include <math.h>
#include <string.h>

# ifdef TEMPLATE
#define GIVEN_STEPS 400
#define GIVEN_START 0.0
#define GIVEN_GRAVITY_X 0.0
#define GIVEN_GRAVITY_Y 900.0
#define GIVEN_AIR 0.1
#define GIVEN_WIND_X 10.0
#define GIVEN_WIND_Y 0.0
#define GIVEN_ACROSS 1.0
#define GIVEN_ALONG 0.5
#define GIVEN_FORWARD 0.2
#define GIVEN_BACKWARD 0.3
#define GIVEN_SIDEWAYS 0.4
#define GIVEN_SLIP 10.0
#define GIVEN_MASSES { { .mass = 1.0 } }
#define GIVEN_SPRINGS { { 0 } }
#define GIVEN_JOINTS { { 0 } }
#define GIVEN_RESISTED { { 0 } }
#define GIVEN_FILLINGS { { 0 } }
#define GIVEN_AROUND { 0 }
#define GIVEN_WALLS { { 0 } }
#define GIVEN_GRIPPED { { 0 } }
#define GIVEN_SIZES { { 0.0 } }
#define GIVEN_SLIDING { { 0 } }
#define GIVEN_MOTORS { { 0 } }
#define GIVEN_PUSHES { { 0 } }
#define GIVEN_EFFORT_X 0.0
#define GIVEN_EFFORT_Y 0.0
#define GIVEN_RAILS { { 0 } }
#define GIVEN_CIRCLES { { 0 } }
#define GIVEN_STRETCHED { { 0 } }
#define GIVEN_BENT { { 0 } }

# endif
# ifdef HAS_MEDIUM
static const double ACROSS = GIVEN_ACROSS, ALONG = GIVEN_ALONG;  // drag of a medium on springs, kg/(px s)
# endif
# ifdef HAS_GROUND
static const double FORWARD = GIVEN_FORWARD, BACKWARD = GIVEN_BACKWARD;  // friction of the ground
static const double SIDEWAYS = GIVEN_SIDEWAYS, SLIP = GIVEN_SLIP;        // SLIP: px/s, of full friction
# endif

# ifdef HAS_RESISTED
static const struct {
    int spring;         // which is resisted
# ifdef HAS_GROUND
    double on_a, on_b;  // the weights on its ends, kg px/s^2
# endif
} resisted[] = GIVEN_RESISTED;
enum { RESISTED = sizeof resisted / sizeof *resisted };

# endif
# ifdef HAS_FILLINGS
static const struct {
    int gas;          // or a liquid
    double strength;  // pressure of a gas at its area, or bulk modulus, kg/s^2
    double outside;   // the pressure outside, kg/s^2
    double area;      // px^2
    int first, end;   // the masses around it, as a part of `around`
} filling[] = GIVEN_FILLINGS;
enum { FILLINGS = sizeof filling / sizeof *filling };
static const int around[] = GIVEN_AROUND;

# endif
# ifdef HAS_GRIPPED
static const struct {
    int wall, mass;  // between which there is a tangential spring at the start
    double stretch;  // px
} gripped[] = GIVEN_GRIPPED;
enum { GRIPPED = sizeof gripped / sizeof *gripped };

# endif
# ifdef HAS_MOTORS
static const struct {
    int joint;      // whose second spring it turns against the first
    double speed;   // the rate at which the angle should grow, 1/s
    double torque;  // the largest, kg px^2/s^2
    double slip;    // how far the rate is off where three quarters of the torque act, 1/s
# ifdef HAS_STEERING
    int steer;      // the index in `body->steer` of what steers it, or -1
# endif
} motor[] = GIVEN_MOTORS;
enum { MOTORS = sizeof motor / sizeof *motor };

# endif
# ifdef HAS_PUSHES
static const struct {
    int mass;       // on which a force acts that keys work
    double fx, fy;  // kg px/s^2
    int steer;      // the index in `body->steer` of what works it
} pushed[] = GIVEN_PUSHES;
enum { PUSHES = sizeof pushed / sizeof *pushed };

# endif
# ifdef HAS_RAILS
static const struct {
    int mass;     // that moves only along a rail
    double x, y;  // the unit vector of the rail
} rail[] = GIVEN_RAILS;
enum { RAILS = sizeof rail / sizeof *rail };

# endif
# ifdef HAS_SIZES
static const struct {
    double radius;  // px, of a mass that is solid; 0 of any other
} solid[SOFTBODY_MASSES] = GIVEN_SIZES;

# endif
# ifdef HAS_SLIDING
static const struct {
    int wall, mass;  // that slides on it at the start, in spite of static friction
} sliding[] = GIVEN_SLIDING;
enum { SLIDING = sizeof sliding / sizeof *sliding };

# endif
# ifdef HAS_CIRCLES
static const struct {
    int mass;          // a held mass that goes round
    double x, y;       // its place at time 0, px
    double radius;     // px
    double frequency;  // turns per second, Hz
    double ramp;       // time constant with which it speeds up, s
} circle[] = GIVEN_CIRCLES;
enum { CIRCLES = sizeof circle / sizeof *circle };

# endif
# ifdef HAS_MUSCLES
typedef struct {
    int part;          // the spring whose rest length it moves, or the joint whose rest angle it moves
    double rest;       // where that rests, px or radians
    double amplitude;  // px or radians
    double rate;       // of the phase, 1/s
    double phase;      // at time 0
    int pulse;         // or a sine
# ifdef HAS_EFFORTS
                       // or, if 2, it is steady: it has no wave
    int steer;         // the index in `body->steer` of what works it, or -1
# endif
} Muscle;
# ifdef HAS_STRETCHED
static const Muscle stretched[] = GIVEN_STRETCHED;
enum { STRETCHED = sizeof stretched / sizeof *stretched };
# endif
# ifdef HAS_BENT
static const Muscle bent[] = GIVEN_BENT;
enum { BENT = sizeof bent / sizeof *bent };
# endif

# endif
// What a body begins with.
static const struct {
    double x, y, vx, vy, mass;
    int held;
# ifdef HAS_LOADS
    double fx, fy;
# endif
} masses[SOFTBODY_MASSES] = GIVEN_MASSES;
# ifdef HAS_SPRINGS
static const struct {
    int a, b;
    double k, rest;
# ifdef HAS_SPRING_SIDES
    int side;
# endif
# ifdef HAS_DAMPING
    double c;
# endif
} springs[SOFTBODY_SPRINGS] = GIVEN_SPRINGS;
# endif
# ifdef HAS_JOINTS
static const softbody_joint joints[SOFTBODY_JOINTS] = GIVEN_JOINTS;
# endif
# ifdef HAS_WALLS
static const softbody_wall walls[SOFTBODY_WALLS] = GIVEN_WALLS;
# endif

# ifdef HAS_GRIPS
static double clamped(double value, double most) {
    return fmin(fmax(value, -most), most);
}

// Where mass i is along wall k, px.
static double place(const softbody *body, int k, int i) {
    return body->mass[i].y * body->wall[k].nx - body->mass[i].x * body->wall[k].ny;
}

// The stretch of the tangential spring between wall k and mass i, px.
static double stretch(const softbody *body, int k, int i) {
# ifdef HAS_BELTS
    double since = SOFTBODY_DT * body->wall[k].speed;  // the end of the last step
    return body->grip[k][i].holds ? body->grip[k][i].stretch + place(body, k, i) - body->grip[k][i].place - since : 0.0;
# else
    return body->grip[k][i].holds ? body->grip[k][i].stretch + place(body, k, i) - body->grip[k][i].place : 0.0;
# endif
}

// The stiffness of the tangential springs of wall k, softened so that a long step makes no energy.
static double stiffness(const softbody *body, int k) {
    return body->wall[k].grip / pow(1.0 + pow(SOFTBODY_DT * SOFTBODY_DT * body->wall[k].grip, 4), 0.25);
}

# endif
# ifdef HAS_STATIC
// The coefficient of the friction between wall k and mass i.
static double limit(const softbody *body, int k, int i) {
    return body->grip[k][i].slides ? body->wall[k].friction : fmax(body->wall[k].still, body->wall[k].friction);
}

# endif
# ifdef HAS_WALLS
// Whether mass i is inside wall k, and the push and the friction then, px/s^2. The push grows with
// the square of the depth, softened so that a long step makes no energy.
static int touches(const softbody *body, int k, int i, double *push, double *rub) {
    double nx = body->wall[k].nx, ny = body->wall[k].ny, hardness = body->wall[k].hardness;
    double depth = (body->wall[k].x - body->mass[i].x) * nx + (body->wall[k].y - body->mass[i].y) * ny;
    double out = body->mass[i].vx * nx + body->mass[i].vy * ny, along = body->mass[i].vy * nx - body->mass[i].vx * ny;
# ifdef HAS_SIZES
    depth += solid[i].radius;
# endif
    if (depth <= 0.0) return 0;
# ifdef HAS_BELTS
    along -= body->wall[k].speed;
# endif
    double elastic = hardness * depth * depth;
    double power = pow(SOFTBODY_DT * (body->wall[k].loss * elastic + 4.0 * SOFTBODY_DT * hardness * depth), 4);
    double gain = 1.0 - (body->wall[k].loss + 0.5 * SOFTBODY_DT / depth * power / (1.0 + power)) * out;
# ifdef HAS_HYSTERESIS
    double fast = pow(SOFTBODY_DT * body->wall[k].hysteresis * elastic, 4);
    double slow = pow(pow(body->wall[k].calm * depth * sqrt(depth), 4) + fast, 0.25);
    gain -= body->wall[k].hysteresis * tanh(out / (slow + 1e-300));
# endif
    *push = elastic * fmax(gain, 0.0) / pow(1.0 + power, 0.25);
# ifdef HAS_STATIC
    double most = limit(body, k, i) * *push, slip = pow(pow(body->wall[k].slip, 4) + pow(SOFTBODY_DT * most, 4), 0.25);
# else
    double most = body->wall[k].friction * *push, slip = pow(pow(body->wall[k].slip, 4) + pow(SOFTBODY_DT * most, 4), 0.25);
# endif
    *rub = most * tanh(along / slip);
# ifdef HAS_GRIPS
    if (body->wall[k].grip > 0.0) {
        double resist = body->wall[k].resist / pow(1.0 + pow(2.0 * SOFTBODY_DT * body->wall[k].resist, 4), 0.25);
        *rub = clamped(clamped(stiffness(body, k) * stretch(body, k, i), most) + resist * along, most);
    }
# endif
    return 1;
}

# endif
# ifdef HAS_STATIC
// Notes the stretch of the tangential spring between wall k and mass i, which is pushed. Where that is as long as
// static friction bears, the mass slides, until it turns round.
static void slide(softbody *body, int k, int i, double push) {
    const softbody_wall *wall = &body->wall[k];
    softbody_grip *grip = &body->grip[k][i];
    double reach = push / stiffness(body, k), most = limit(body, k, i) * reach;
    double along = body->mass[i].vy * wall->nx - body->mass[i].vx * wall->ny;
# ifdef HAS_BELTS
    along -= wall->speed;
# endif
    grip->stretch = clamped(stretch(body, k, i), most);
    if (grip->slides) grip->slides = grip->stretch * along > 0.0;
    else if (wall->still > wall->friction && fabs(grip->stretch) >= (1.0 - 1e-9) * most) {
        grip->slides = 1;
        grip->stretch = clamped(grip->stretch, wall->friction * reach);
    }
}

# endif
# ifdef HAS_GRIPS
// After a step, notes the stretch of each tangential spring. What is more than friction bears has slid.
static void stick(softbody *body) {
    double push, rub;
    for (int k = 0; k < SOFTBODY_WALLS; k++) {
        if (body->wall[k].grip == 0.0) continue;
        for (int i = 0; i < SOFTBODY_MASSES; i++) {
            int holds = touches(body, k, i, &push, &rub);
# ifdef HAS_STATIC
            if (holds) slide(body, k, i, push);
            else body->grip[k][i].slides = 0;
# else
            if (holds) body->grip[k][i].stretch = clamped(stretch(body, k, i), body->wall[k].friction * push / stiffness(body, k));
# endif
            body->grip[k][i].place = place(body, k, i);
            body->grip[k][i].holds = holds;
        }
    }
}

# endif
# ifdef HAS_RAILS
// Takes what is across the r-th rail out of a vector.
static void keep_along(int r, double *x, double *y) {
    double along = rail[r].x * *x + rail[r].y * *y;
    *x = rail[r].x * along, *y = rail[r].y * along;
}

# endif
static void accelerate(softbody *body) {
    for (int i = 0; i < SOFTBODY_MASSES; i++) {
        body->mass[i].ax = body->mass[i].fx, body->mass[i].ay = body->mass[i].fy;
    }
# ifdef HAS_PUSHES
    for (int i = 0; i < PUSHES; i++) {
        double way = body->steer[pushed[i].steer];
        body->mass[pushed[i].mass].ax += way * pushed[i].fx, body->mass[pushed[i].mass].ay += way * pushed[i].fy;
    }
# endif
# ifdef HAS_SPRINGS
    for (int i = 0; i < SOFTBODY_SPRINGS; i++) {
        int a = body->spring[i].a, b = body->spring[i].b;
        double x = body->mass[b].x - body->mass[a].x, y = body->mass[b].y - body->mass[a].y;
        double length = sqrt(x * x + y * y + 1e-300);  // never 0, to divide by it
        double pull = -body->spring[i].k * (length - body->spring[i].rest);
# ifdef HAS_RATES
        double rx = body->mass[b].vx - body->mass[a].vx, ry = body->mass[b].vy - body->mass[a].vy;
# endif
# ifdef HAS_DAMPING
        pull -= body->spring[i].c * (x * rx + y * ry) / length;
# endif
# ifdef HAS_SPRING_SIDES
        // One of one side exerts nothing on the other, and damping does not turn its force round.
        double side = body->spring[i].side, elastic = body->spring[i].k * (length - body->spring[i].rest);
        if (side && !(side * elastic > 0.0 && side * pull < 0.0)) pull = 0.0;
# endif
        pull /= length;
# ifdef HAS_JOINTS
        body->spring[i].fx = pull * x, body->spring[i].fy = pull * y;
        body->spring[i].x = x, body->spring[i].y = y, body->spring[i].length = length;
# ifdef HAS_TURNING
        body->spring[i].rx = rx, body->spring[i].ry = ry;
# endif
# else
        body->mass[b].ax += pull * x, body->mass[b].ay += pull * y;
        body->mass[a].ax -= pull * x, body->mass[a].ay -= pull * y;
# endif
    }
# endif
# ifdef HAS_JOINTS
    // Joints: the angle from p to q is drawn to the rest angle; see `sim.forces.reference`.
    for (int i = 0; i < SOFTBODY_JOINTS; i++) {
        int p = body->joint[i].p, q = body->joint[i].q;
        double pp = body->spring[p].length * body->spring[p].length, qq = body->spring[q].length * body->spring[q].length;
        double cross = body->spring[p].x * body->spring[q].y - body->spring[p].y * body->spring[q].x;
        double dot = body->spring[p].x * body->spring[q].x + body->spring[p].y * body->spring[q].y;
# ifdef HAS_ANGLE_LAW
        const double PI = 3.141592653589793;
        double off = atan2(cross, dot) - body->joint[i].rest;
        if (off > PI) off -= 2.0 * PI;
        if (off < -PI) off += 2.0 * PI;
        double torque = body->joint[i].k * body->spring[p].length * body->spring[q].length * off, energy = 0.5 * torque * off;
# else
        double torque = body->joint[i].k * (body->joint[i].cosine * cross - body->joint[i].sine * dot);
# endif
# ifdef HAS_CONSERVATIVE_LAW
        double energy = body->joint[i].k * (body->spring[p].length * body->spring[q].length - body->joint[i].cosine * dot - body->joint[i].sine * cross);
# endif
# ifdef HAS_JOINT_DAMPING
        double turning_p = (body->spring[p].x * body->spring[p].ry - body->spring[p].y * body->spring[p].rx) / pp;
        double turning_q = (body->spring[q].x * body->spring[q].ry - body->spring[q].y * body->spring[q].rx) / qq;
        torque += body->joint[i].c * body->spring[p].length * body->spring[q].length * (turning_q - turning_p);
# endif
# ifdef HAS_JOINT_SIDES
        // One of one side exerts nothing on the other, and damping does not turn its torque round.
# ifdef HAS_ANGLE_LAW
        double beyond = off;
# else
        double beyond = body->joint[i].cosine * cross - body->joint[i].sine * dot;
# endif
        double side = body->joint[i].side;
        if (side && !(side * beyond > 0.0 && side * torque > 0.0)) continue;
# endif
        body->spring[p].fx -= torque * body->spring[p].y / pp, body->spring[p].fy += torque * body->spring[p].x / pp;
        body->spring[q].fx += torque * body->spring[q].y / qq, body->spring[q].fy -= torque * body->spring[q].x / qq;
# ifdef HAS_JOINT_ENERGY
        // The energy grows with the lengths, and so pulls along the springs.
        body->spring[p].fx -= energy * body->spring[p].x / pp, body->spring[p].fy -= energy * body->spring[p].y / pp;
        body->spring[q].fx -= energy * body->spring[q].x / qq, body->spring[q].fy -= energy * body->spring[q].y / qq;
# endif
    }
# ifdef HAS_MOTORS
    for (int i = 0; i < MOTORS; i++) {
        softbody_spring *p = &body->spring[body->joint[motor[i].joint].p], *q = &body->spring[body->joint[motor[i].joint].q];
        double pp = p->length * p->length, qq = q->length * q->length;
        double rate = (q->x * q->ry - q->y * q->rx) / qq - (p->x * p->ry - p->y * p->rx) / pp, wanted = motor[i].speed;
# ifdef HAS_STEERING
        if (motor[i].steer >= 0) wanted *= body->steer[motor[i].steer];
# endif
        double torque = motor[i].torque * tanh((wanted - rate) / motor[i].slip);
        p->fx += torque * p->y / pp, p->fy -= torque * p->x / pp;
        q->fx -= torque * q->y / qq, q->fy += torque * q->x / qq;
    }
# endif
    for (int i = 0; i < SOFTBODY_SPRINGS; i++) {
        softbody_mass *a = &body->mass[body->spring[i].a], *b = &body->mass[body->spring[i].b];
        b->ax += body->spring[i].fx, b->ay += body->spring[i].fy;
        a->ax -= body->spring[i].fx, a->ay -= body->spring[i].fy;
    }
# endif
# ifdef HAS_RESISTED
    // Springs are resisted at both ends, otherwise across than along themselves.
    for (int i = 0; i < RESISTED; i++) {
        int ends[2] = { body->spring[resisted[i].spring].a, body->spring[resisted[i].spring].b };
        double x = body->mass[ends[1]].x - body->mass[ends[0]].x, y = body->mass[ends[1]].y - body->mass[ends[0]].y;
        double length = sqrt(x * x + y * y + 1e-300);
        x /= length, y /= length;
        for (int end = 0; end < 2; end++) {
            int k = ends[end];
            double along = 0.0, across = 0.0;
# ifdef HAS_MEDIUM
            double u = body->mass[k].vx, w = body->mass[k].vy;
# ifdef HAS_WIND
            u -= body->wind_x, w -= body->wind_y;
# endif
            along += 0.5 * length * ALONG * (x * u + y * w);
            across += 0.5 * length * ACROSS * (x * w - y * u);
# endif
# ifdef HAS_GROUND
            double forward = x * body->mass[k].vx + y * body->mass[k].vy, sideways = x * body->mass[k].vy - y * body->mass[k].vx;
            double speed = sqrt(forward * forward + sideways * sideways + SLIP * SLIP);
            double rub = (end ? resisted[i].on_b : resisted[i].on_a) / speed;
            along += rub * (forward > 0.0 ? FORWARD : BACKWARD) * forward;
            across += rub * SIDEWAYS * sideways;
# endif
            body->mass[k].ax -= along * x - across * y, body->mass[k].ay -= along * y + across * x;
        }
    }
# endif
# ifdef HAS_FILLINGS
    for (int k = 0; k < FILLINGS; k++) {
        int first = filling[k].first, n = filling[k].end - first;
        double x0 = body->mass[around[first]].x, y0 = body->mass[around[first]].y, area = 0.0, pressure;
        for (int i = 0; i < n; i++) {
            int here = around[first + i], next = around[first + (i + 1) % n];
            area += 0.5 * ((body->mass[here].x - x0) * (body->mass[next].y - y0) - (body->mass[here].y - y0) * (body->mass[next].x - x0));
        }
        double part = area / filling[k].area;
        if (!filling[k].gas) pressure = filling[k].strength * (1.0 - part);
        else if (part > 0.01) pressure = filling[k].strength / part - filling[k].outside;
        else  // nearly nothing is left: no division by zero
            pressure = filling[k].strength * (2.0 - part / 0.01) / 0.01 - filling[k].outside;
        for (int i = 0; i < n; i++) {
            int before = around[first + (i + n - 1) % n], next = around[first + (i + 1) % n];
            softbody_mass *here = &body->mass[around[first + i]];
            here->ax += 0.5 * pressure * (body->mass[next].y - body->mass[before].y);
            here->ay += 0.5 * pressure * (body->mass[before].x - body->mass[next].x);
        }
    }
# endif
    for (int i = 0; i < SOFTBODY_MASSES; i++) {
        body->mass[i].ax /= body->mass[i].mass, body->mass[i].ay /= body->mass[i].mass;
# ifdef HAS_AIR
        double u = body->mass[i].vx, w = body->mass[i].vy;
# ifdef HAS_WIND
        u -= body->wind_x, w -= body->wind_y;
# endif
# ifdef HAS_AIR_BY_AXES
        u *= fabs(u), w *= fabs(w);
# endif
# ifdef HAS_AIR_BY_SPEED
        double speed = sqrt(u * u + w * w);
        u *= speed, w *= speed;
# endif
        body->mass[i].ax -= body->air * u / body->mass[i].mass, body->mass[i].ay -= body->air * w / body->mass[i].mass;
# endif
# ifdef HAS_GRAVITY
        body->mass[i].ax += body->gravity_x, body->mass[i].ay += body->gravity_y;
# endif
# ifdef HAS_WALLS
        for (int k = 0; k < SOFTBODY_WALLS; k++) {
            double push, rub;
            if (!touches(body, k, i, &push, &rub)) continue;
            body->mass[i].ax += push * body->wall[k].nx + rub * body->wall[k].ny, body->mass[i].ay += push * body->wall[k].ny - rub * body->wall[k].nx;
        }
# endif
    }
# ifdef HAS_RAILS
    for (int r = 0; r < RAILS; r++) keep_along(r, &body->mass[rail[r].mass].ax, &body->mass[rail[r].mass].ay);
# endif
}

# ifdef HAS_CIRCLES
// Puts masses on circles where they are at time t.
static void lead(softbody *body, double t) {
    for (int k = 0; k < CIRCLES; k++) {
        const double TAU = 6.283185307179586;
        double fade = exp(-t / circle[k].ramp), turn = TAU * circle[k].frequency;
        double phase = turn * (t - circle[k].ramp * (1.0 - fade));
        double radius = circle[k].radius, speed = radius * turn * (1.0 - fade);
        int i = circle[k].mass;
        body->mass[i].x = circle[k].x + radius * sin(phase);
        body->mass[i].y = circle[k].y + radius * (1.0 - cos(phase));
        body->mass[i].vx = speed * cos(phase), body->mass[i].vy = speed * sin(phase);
# ifdef HAS_RAILED_CIRCLES
        for (int r = 0; r < RAILS; r++) {  // one on a rail goes to and fro along it
            if (rail[r].mass != i) continue;
            double x = body->mass[i].x - circle[k].x, y = body->mass[i].y - circle[k].y;
            keep_along(r, &x, &y);
            keep_along(r, &body->mass[i].vx, &body->mass[i].vy);
            body->mass[i].x = circle[k].x + x, body->mass[i].y = circle[k].y + y;
        }
# endif
    }
}

# endif
# ifdef HAS_MUSCLES
// The rest length or the rest angle that a muscle moves, at time t.
static double moved(Muscle muscle, double t) {
    double wave = sin(muscle.rate * t + muscle.phase);
    return muscle.rest + muscle.amplitude * (muscle.pulse ? exp(4.0 * (wave - 1.0)) : wave);
}

# ifdef HAS_EFFORTS
// A muscle as keys make it now: as large as their effort, backwards where that is below 0.
static Muscle worked(const softbody *body, Muscle muscle) {
    if (muscle.steer < 0) return muscle;
    double effort = body->effort[muscle.steer];
    if (muscle.pulse == 2) muscle.rest += muscle.amplitude * effort;
    muscle.rate = copysign(muscle.rate, effort);
    muscle.amplitude *= muscle.pulse == 2 ? 0.0 : fabs(effort);
    return muscle;
}

# endif
// Lets all muscles move to where they are at time t.
static void flex(softbody *body, double t) {
# ifdef HAS_EFFORTS
    for (int k = 0; k < 2; k++) body->effort[k] = body->steer[k] + (body->effort[k] - body->steer[k]) * exp(-SOFTBODY_DT / 0.05);
# endif
# ifdef HAS_STRETCHED
# ifdef HAS_EFFORTS
    for (int i = 0; i < STRETCHED; i++) body->spring[stretched[i].part].rest = moved(worked(body, stretched[i]), t);
# else
    for (int i = 0; i < STRETCHED; i++) body->spring[stretched[i].part].rest = moved(stretched[i], t);
# endif
# endif
# ifdef HAS_BENT
    for (int i = 0; i < BENT; i++) {
# ifdef HAS_EFFORTS
        double angle = moved(worked(body, bent[i]), t);
# else
        double angle = moved(bent[i], t);
# endif
# ifdef HAS_ANGLE_LAW
        body->joint[bent[i].part].rest = remainder(angle, 6.283185307179586);
# else
        body->joint[bent[i].part].cosine = cos(angle), body->joint[bent[i].part].sine = sin(angle);
# endif
    }
# endif
}

# endif
void softbody_reset(softbody *body) {
    memset(body, 0, sizeof *body);
    body->before_step = NULL, body->data = NULL, body->time = GIVEN_START;
# ifdef HAS_GRAVITY
    body->gravity_x = GIVEN_GRAVITY_X, body->gravity_y = GIVEN_GRAVITY_Y;
# endif
# ifdef HAS_AIR
    body->air = GIVEN_AIR;
# endif
# ifdef HAS_EFFORTS
    body->effort[0] = GIVEN_EFFORT_X, body->effort[1] = GIVEN_EFFORT_Y;
# endif
# ifdef HAS_WIND
    body->wind_x = GIVEN_WIND_X, body->wind_y = GIVEN_WIND_Y;
# endif
    for (int i = 0; i < SOFTBODY_MASSES; i++) {
        softbody_mass *m = &body->mass[i];
        m->x = m->old_x = masses[i].x, m->y = m->old_y = masses[i].y;
        m->vx = masses[i].vx, m->vy = masses[i].vy, m->mass = masses[i].mass, m->held = masses[i].held;
# ifdef HAS_LOADS
        m->fx = masses[i].fx, m->fy = masses[i].fy;
# endif
    }
# ifdef HAS_SPRINGS
    for (int i = 0; i < SOFTBODY_SPRINGS; i++) {
        softbody_spring *s = &body->spring[i];
        s->a = springs[i].a, s->b = springs[i].b, s->k = springs[i].k, s->rest = springs[i].rest;
# ifdef HAS_SPRING_SIDES
        s->side = springs[i].side;
# endif
# ifdef HAS_DAMPING
        s->c = springs[i].c;
# endif
    }
# endif
# ifdef HAS_JOINTS
    memcpy(body->joint, joints, sizeof joints);
# endif
# ifdef HAS_WALLS
    memcpy(body->wall, walls, sizeof walls);
# endif
# ifdef HAS_GRIPPED
    for (int g = 0; g < GRIPPED; g++) {
        int k = gripped[g].wall, i = gripped[g].mass;
        softbody_grip *grip = &body->grip[k][i];
        grip->holds = 1, grip->stretch = gripped[g].stretch, grip->place = place(body, k, i);
    }
# endif
# ifdef HAS_SLIDING
    for (int s = 0; s < SLIDING; s++) body->grip[sliding[s].wall][sliding[s].mass].slides = 1;
# endif
}

void softbody_step(softbody *body) {
    if (body->before_step) body->before_step(body, body->data);
    body->time += SOFTBODY_DT;
# ifdef HAS_MUSCLES
    flex(body, body->time);
# endif
    accelerate(body);
    for (int i = 0; i < SOFTBODY_MASSES; i++) {
        softbody_mass *m = &body->mass[i];
        m->old_x = m->x, m->old_y = m->y;
        if (m->held) continue;
        m->vx += SOFTBODY_DT * m->ax, m->vy += SOFTBODY_DT * m->ay;
        m->x += SOFTBODY_DT * m->vx, m->y += SOFTBODY_DT * m->vy;
    }
# ifdef HAS_CIRCLES
    lead(body, body->time);
# endif
# ifdef HAS_GRIPS
    stick(body);
# endif
}

int softbody_advance(softbody *body, double seconds) {
    // After a long pause the game goes on, instead of catching up for ever.
    body->owed += seconds > 0.0 ? fmin(seconds, SOFTBODY_LONGEST) : 0.0;
    // A hair more, so that ten times 0.0025 s are ten steps whatever the rounding.
    for (long n = (long)floor(body->owed / SOFTBODY_DT + 1e-9); n > 0; n--) {
        softbody_step(body);
        body->owed -= SOFTBODY_DT;
    }
    body->owed = fmax(body->owed, 0.0);
    for (int i = 0; i < SOFTBODY_MASSES; i++) {
        if (!isfinite(body->mass[i].x) || !isfinite(body->mass[i].y)) return 0;
    }
    return 1;
}

void softbody_shown(const softbody *body, int mass, double *x, double *y) {
    double part = fmin(body->owed / SOFTBODY_DT, 1.0);
    const softbody_mass *m = &body->mass[mass];
    *x = m->old_x + part * (m->x - m->old_x), *y = m->old_y + part * (m->y - m->old_y);
}

void softbody_impulse(softbody *body, int mass, double px, double py) {
    softbody_mass *m = &body->mass[mass];
    if (m->held) return;
    m->vx += px / m->mass, m->vy += py / m->mass;
# ifdef HAS_RAILS
    for (int r = 0; r < RAILS; r++) {
        if (rail[r].mass == mass) keep_along(r, &m->vx, &m->vy);
    }
# endif
}

# ifdef HAS_WALLS
void softbody_move_wall(softbody *body, int wall, double x, double y) {
    body->wall[wall].x = x, body->wall[wall].y = y;
# ifdef HAS_GRIPS
    for (int i = 0; i < SOFTBODY_MASSES; i++) body->grip[wall][i].holds = 0;
# ifdef HAS_STATIC
    for (int i = 0; i < SOFTBODY_MASSES; i++) body->grip[wall][i].slides = 0;
# endif
# endif
}

# endif
#ifdef SOFTBODY_MAIN
// What it is tried by: does some steps, and prints x and y of every mass.
#include <stdio.h>
#include <stdlib.h>

int main(int count, char **words) {
    static softbody body;
    long steps = count > 1 ? atol(words[1]) : GIVEN_STEPS;
    softbody_reset(&body);
    for (long i = 0; i < steps; i++) softbody_step(&body);
    for (int i = 0; i < SOFTBODY_MASSES; i++) printf("%.17g %.17g\n", body.mass[i].x, body.mass[i].y);
    return 0;
}
#endif
