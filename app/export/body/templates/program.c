// GIVEN_ABOUT
# ifdef HAS_MATHEMATICS
#include <math.h>
# endif
#include <stdio.h>
#include <stdlib.h>

# ifdef TEMPLATE
// What stands for a scene's numbers while this file is compiled as it is.
// `app/export/body/program.py` fills it.
#define GIVEN_STEPS 400
#define GIVEN_START 0.0
#define GIVEN_DT 0.001
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
#define GIVEN_LOADS { { 0 } }
#define GIVEN_RESISTED { { 0 } }
#define GIVEN_FILLINGS { { 0 } }
#define GIVEN_AROUND { 0 }
#define GIVEN_WALLS { { 0 } }
#define GIVEN_GRIPPED { { 0 } }
#define GIVEN_CIRCLES { { 0 } }
#define GIVEN_STRETCHED { { 0 } }
#define GIVEN_BENT { { 0 } }

# endif
static const double DT = GIVEN_DT;  // time step, s
# ifdef HAS_GRAVITY
static const double GRAVITY_X = GIVEN_GRAVITY_X, GRAVITY_Y = GIVEN_GRAVITY_Y;  // px/s^2
# endif
# ifdef HAS_AIR
static const double AIR = GIVEN_AIR;  // air friction, kg/px
# endif
# ifdef HAS_WIND
static const double WIND_X = GIVEN_WIND_X, WIND_Y = GIVEN_WIND_Y;  // velocity of the air, px/s
# endif
# ifdef HAS_MEDIUM
static const double ACROSS = GIVEN_ACROSS, ALONG = GIVEN_ALONG;  // drag of a medium on springs, kg/(px s)
# endif
# ifdef HAS_GROUND
static const double FORWARD = GIVEN_FORWARD, BACKWARD = GIVEN_BACKWARD;  // friction of the ground
static const double SIDEWAYS = GIVEN_SIDEWAYS, SLIP = GIVEN_SLIP;        // SLIP: px/s, of full friction
# endif

static struct {
    double x, y;    // where the mass is, px
    double vx, vy;  // its velocity, px/s
    double mass;    // kg
# ifdef HAS_HELD
    int held;
# endif
} m[] = GIVEN_MASSES;
enum { MASSES = sizeof m / sizeof *m };
static double ax[MASSES], ay[MASSES];  // forces (kg px/s^2), then accelerations (px/s^2)

# ifdef HAS_SPRINGS
# ifdef HAS_STRETCHED
static struct {
# else
static const struct {
# endif
    int a, b;     // masses at the ends of the spring
    double k;     // stiffness, kg/s^2
    double rest;  // rest length, px
# ifdef HAS_DAMPING
    double c;     // damping, kg/s
# endif
} s[] = GIVEN_SPRINGS;
enum { SPRINGS = sizeof s / sizeof *s };

# endif
# ifdef HAS_JOINTS
# ifdef HAS_BENT
static struct {
# else
static const struct {
# endif
    int p, q;     // springs of the joint
    double k;     // stiffness, kg/s^2
# ifdef HAS_ANGLE_LAW
    double rest;  // rest angle, radians
# else
    double cosine, sine;  // of the rest angle
# endif
# ifdef HAS_JOINT_DAMPING
    double c;     // damping, kg/s
# endif
} j[] = GIVEN_JOINTS;
enum { JOINTS = sizeof j / sizeof *j };

static struct {
    double x, y, length;  // of each spring now: its vector and length, px
    double fx, fy;        // the force on mass b, kg px/s^2
# ifdef HAS_JOINT_DAMPING
    double rx, ry;        // how fast the vector changes, px/s
# endif
} now[SPRINGS];

# endif
# ifdef HAS_LOADS
static const struct {
    int mass;     // on which a constant force acts
    double x, y;  // the force, kg px/s^2
} load[] = GIVEN_LOADS;
enum { LOADS = sizeof load / sizeof *load };

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
# ifdef HAS_WALLS
static const struct {
    double x, y;      // a point of the wall, px
    double nx, ny;    // the unit vector to the free side
    double hardness;  // 1/(px s^2)
    double friction;
    double slip;      // slip speed, px/s
    double loss;      // how much harder masses are pushed that enter faster, s/px
# ifdef HAS_HYSTERESIS
    double hysteresis;  // how much harder they are pushed on the way in
    double calm;        // from what speeds on, px^(-1/2)/s
# endif
# ifdef HAS_GRIPS
    double grip;      // stiffness of tangential springs, by which friction holds, 1/s^2
    double resist;    // damping of them, 1/s
# endif
} wall[] = GIVEN_WALLS;
enum { WALLS = sizeof wall / sizeof *wall };

# ifdef HAS_GRIPS
static struct {
    int holds;       // there is a tangential spring between this wall and this mass
    double stretch;  // px
    double place;    // where along the wall the mass was when it had this stretch, px
} grip[WALLS][MASSES];
# endif
# ifdef HAS_GRIPPED
static const struct {
    int wall, mass;  // between which there is a tangential spring at the start
    double stretch;  // px
} gripped[] = GIVEN_GRIPPED;
enum { GRIPPED = sizeof gripped / sizeof *gripped };

# endif
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
# ifdef HAS_GRIPS
static double clamped(double value, double most) {
    return fmin(fmax(value, -most), most);
}

// Where mass i is along wall k, px.
static double place(int k, int i) {
    return m[i].y * wall[k].nx - m[i].x * wall[k].ny;
}

// The stretch of the tangential spring between wall k and mass i, px.
static double stretch(int k, int i) {
    return grip[k][i].holds ? grip[k][i].stretch + place(k, i) - grip[k][i].place : 0.0;
}

// The stiffness of the tangential springs of wall k, softened so that a long step makes no energy.
static double stiffness(int k) {
    return wall[k].grip / pow(1.0 + pow(DT * DT * wall[k].grip, 4), 0.25);
}

# endif
# ifdef HAS_WALLS
// Whether mass i is inside wall k, and the push and the friction then, px/s^2. The push grows with
// the square of the depth, softened so that a long step makes no energy.
static int touches(int k, int i, double *push, double *rub) {
    double nx = wall[k].nx, ny = wall[k].ny, hardness = wall[k].hardness;
    double depth = (wall[k].x - m[i].x) * nx + (wall[k].y - m[i].y) * ny;
    double out = m[i].vx * nx + m[i].vy * ny, along = m[i].vy * nx - m[i].vx * ny;
    if (depth <= 0.0) return 0;
    double elastic = hardness * depth * depth;
    double power = pow(DT * (wall[k].loss * elastic + 4.0 * DT * hardness * depth), 4);
    double gain = 1.0 - (wall[k].loss + 0.5 * DT / depth * power / (1.0 + power)) * out;
# ifdef HAS_HYSTERESIS
    double fast = pow(DT * wall[k].hysteresis * elastic, 4);
    double slow = pow(pow(wall[k].calm * depth * sqrt(depth), 4) + fast, 0.25);
    gain -= wall[k].hysteresis * tanh(out / (slow + 1e-300));
# endif
    *push = elastic * fmax(gain, 0.0) / pow(1.0 + power, 0.25);
    double most = wall[k].friction * *push, slip = pow(pow(wall[k].slip, 4) + pow(DT * most, 4), 0.25);
    *rub = most * tanh(along / slip);
# ifdef HAS_GRIPS
    if (wall[k].grip > 0.0) {
        double resist = wall[k].resist / pow(1.0 + pow(2.0 * DT * wall[k].resist, 4), 0.25);
        *rub = clamped(clamped(stiffness(k) * stretch(k, i), most) + resist * along, most);
    }
# endif
    return 1;
}

# endif
# ifdef HAS_GRIPS
// After a step, notes the stretch of each tangential spring. What is more than friction bears has slid.
static void stick(void) {
    double push, rub;
    for (int k = 0; k < WALLS; k++) {
        if (wall[k].grip == 0.0) continue;
        for (int i = 0; i < MASSES; i++) {
            int holds = touches(k, i, &push, &rub);
            if (holds) grip[k][i].stretch = clamped(stretch(k, i), wall[k].friction * push / stiffness(k));
            grip[k][i].place = place(k, i);
            grip[k][i].holds = holds;
        }
    }
}

# endif
static void accelerate(void) {
    for (int i = 0; i < MASSES; i++) ax[i] = ay[i] = 0.0;
# ifdef HAS_LOADS
    for (int i = 0; i < LOADS; i++) ax[load[i].mass] = load[i].x, ay[load[i].mass] = load[i].y;
# endif
# ifdef HAS_SPRINGS
    for (int i = 0; i < SPRINGS; i++) {
        int a = s[i].a, b = s[i].b;
        double x = m[b].x - m[a].x, y = m[b].y - m[a].y;
        double length = sqrt(x * x + y * y + 1e-300);  // never 0, to divide by it
        double pull = -s[i].k * (length - s[i].rest);
# ifdef HAS_RATES
        double rx = m[b].vx - m[a].vx, ry = m[b].vy - m[a].vy;
# endif
# ifdef HAS_DAMPING
        pull -= s[i].c * (x * rx + y * ry) / length;
# endif
        pull /= length;
# ifdef HAS_JOINTS
        now[i].fx = pull * x, now[i].fy = pull * y;
        now[i].x = x, now[i].y = y, now[i].length = length;
# ifdef HAS_JOINT_DAMPING
        now[i].rx = rx, now[i].ry = ry;
# endif
# else
        ax[b] += pull * x, ay[b] += pull * y;
        ax[a] -= pull * x, ay[a] -= pull * y;
# endif
    }
# endif
# ifdef HAS_JOINTS
    // Joints: the angle from p to q is drawn to the rest angle; see `sim.physics`.
    for (int i = 0; i < JOINTS; i++) {
        int p = j[i].p, q = j[i].q;
        double pp = now[p].length * now[p].length, qq = now[q].length * now[q].length;
        double cross = now[p].x * now[q].y - now[p].y * now[q].x;
        double dot = now[p].x * now[q].x + now[p].y * now[q].y;
# ifdef HAS_ANGLE_LAW
        const double PI = 3.141592653589793;
        double off = atan2(cross, dot) - j[i].rest;
        if (off > PI) off -= 2.0 * PI;
        if (off < -PI) off += 2.0 * PI;
        double torque = j[i].k * now[p].length * now[q].length * off, energy = 0.5 * torque * off;
# else
        double torque = j[i].k * (j[i].cosine * cross - j[i].sine * dot);
# endif
# ifdef HAS_CONSERVATIVE_LAW
        double energy = j[i].k * (now[p].length * now[q].length - j[i].cosine * dot - j[i].sine * cross);
# endif
# ifdef HAS_JOINT_DAMPING
        double turning_p = (now[p].x * now[p].ry - now[p].y * now[p].rx) / pp;
        double turning_q = (now[q].x * now[q].ry - now[q].y * now[q].rx) / qq;
        torque += j[i].c * now[p].length * now[q].length * (turning_q - turning_p);
# endif
        now[p].fx -= torque * now[p].y / pp, now[p].fy += torque * now[p].x / pp;
        now[q].fx += torque * now[q].y / qq, now[q].fy -= torque * now[q].x / qq;
# ifdef HAS_JOINT_ENERGY
        // The energy grows with the lengths, and so pulls along the springs.
        now[p].fx -= energy * now[p].x / pp, now[p].fy -= energy * now[p].y / pp;
        now[q].fx -= energy * now[q].x / qq, now[q].fy -= energy * now[q].y / qq;
# endif
    }
    for (int i = 0; i < SPRINGS; i++) {
        ax[s[i].b] += now[i].fx, ay[s[i].b] += now[i].fy;
        ax[s[i].a] -= now[i].fx, ay[s[i].a] -= now[i].fy;
    }
# endif
# ifdef HAS_RESISTED
    // Springs are resisted at both ends, otherwise across than along themselves.
    for (int i = 0; i < RESISTED; i++) {
        int ends[2] = { s[resisted[i].spring].a, s[resisted[i].spring].b };
        double x = m[ends[1]].x - m[ends[0]].x, y = m[ends[1]].y - m[ends[0]].y;
        double length = sqrt(x * x + y * y + 1e-300);
        x /= length, y /= length;
        for (int end = 0; end < 2; end++) {
            int k = ends[end];
            double along = 0.0, across = 0.0;
# ifdef HAS_MEDIUM
            double u = m[k].vx, w = m[k].vy;
# ifdef HAS_WIND
            u -= WIND_X, w -= WIND_Y;
# endif
            along += 0.5 * length * ALONG * (x * u + y * w);
            across += 0.5 * length * ACROSS * (x * w - y * u);
# endif
# ifdef HAS_GROUND
            double forward = x * m[k].vx + y * m[k].vy, sideways = x * m[k].vy - y * m[k].vx;
            double speed = sqrt(forward * forward + sideways * sideways + SLIP * SLIP);
            double rub = (end ? resisted[i].on_b : resisted[i].on_a) / speed;
            along += rub * (forward > 0.0 ? FORWARD : BACKWARD) * forward;
            across += rub * SIDEWAYS * sideways;
# endif
            ax[k] -= along * x - across * y, ay[k] -= along * y + across * x;
        }
    }
# endif
# ifdef HAS_FILLINGS
    for (int k = 0; k < FILLINGS; k++) {
        int first = filling[k].first, n = filling[k].end - first;
        double x0 = m[around[first]].x, y0 = m[around[first]].y, area = 0.0, pressure;
        for (int i = 0; i < n; i++) {
            int here = around[first + i], next = around[first + (i + 1) % n];
            area += 0.5 * ((m[here].x - x0) * (m[next].y - y0) - (m[here].y - y0) * (m[next].x - x0));
        }
        double part = area / filling[k].area;
        if (!filling[k].gas) pressure = filling[k].strength * (1.0 - part);
        else if (part > 0.01) pressure = filling[k].strength / part - filling[k].outside;
        else  // nearly nothing is left: no division by zero
            pressure = filling[k].strength * (2.0 - part / 0.01) / 0.01 - filling[k].outside;
        for (int i = 0; i < n; i++) {
            int before = around[first + (i + n - 1) % n], next = around[first + (i + 1) % n];
            ax[around[first + i]] += 0.5 * pressure * (m[next].y - m[before].y);
            ay[around[first + i]] += 0.5 * pressure * (m[before].x - m[next].x);
        }
    }
# endif
    for (int i = 0; i < MASSES; i++) {
        ax[i] /= m[i].mass, ay[i] /= m[i].mass;
# ifdef HAS_AIR
        // Air friction acts along each axis.
        double u = m[i].vx, w = m[i].vy;
# ifdef HAS_WIND
        u -= WIND_X, w -= WIND_Y;
# endif
        ax[i] -= AIR * u * fabs(u) / m[i].mass, ay[i] -= AIR * w * fabs(w) / m[i].mass;
# endif
# ifdef HAS_GRAVITY
        ax[i] += GRAVITY_X, ay[i] += GRAVITY_Y;
# endif
# ifdef HAS_WALLS
        for (int k = 0; k < WALLS; k++) {
            double push, rub;
            if (!touches(k, i, &push, &rub)) continue;
            ax[i] += push * wall[k].nx + rub * wall[k].ny, ay[i] += push * wall[k].ny - rub * wall[k].nx;
        }
# endif
    }
}

# ifdef HAS_CIRCLES
// Puts masses on circles where they are at time t.
static void lead(double t) {
    for (int k = 0; k < CIRCLES; k++) {
        const double TAU = 6.283185307179586;
        double fade = exp(-t / circle[k].ramp), turn = TAU * circle[k].frequency;
        double phase = turn * (t - circle[k].ramp * (1.0 - fade));
        double radius = circle[k].radius, speed = radius * turn * (1.0 - fade);
        int i = circle[k].mass;
        m[i].x = circle[k].x + radius * sin(phase);
        m[i].y = circle[k].y + radius * (1.0 - cos(phase));
        m[i].vx = speed * cos(phase), m[i].vy = speed * sin(phase);
    }
}

# endif
# ifdef HAS_MUSCLES
// The rest length or the rest angle that a muscle moves, at time t.
static double moved(Muscle muscle, double t) {
    double wave = sin(muscle.rate * t + muscle.phase);
    return muscle.rest + muscle.amplitude * (muscle.pulse ? exp(4.0 * (wave - 1.0)) : wave);
}

// Lets all muscles move to where they are at time t.
static void flex(double t) {
# ifdef HAS_STRETCHED
    for (int i = 0; i < STRETCHED; i++) s[stretched[i].part].rest = moved(stretched[i], t);
# endif
# ifdef HAS_BENT
    for (int i = 0; i < BENT; i++) {
        double angle = moved(bent[i], t);
# ifdef HAS_ANGLE_LAW
        j[bent[i].part].rest = remainder(angle, 6.283185307179586);
# else
        j[bent[i].part].cosine = cos(angle), j[bent[i].part].sine = sin(angle);
# endif
    }
# endif
}

# endif
// One time step.
static void step(void) {
# ifdef HAS_TIME
    static double t = GIVEN_START;  // s
    t += DT;
# endif
# ifdef HAS_MUSCLES
    flex(t);
# endif
    accelerate();
    for (int i = 0; i < MASSES; i++) {
# ifdef HAS_HELD
        if (m[i].held) continue;
# endif
        m[i].vx += DT * ax[i], m[i].vy += DT * ay[i];
        m[i].x += DT * m[i].vx, m[i].y += DT * m[i].vy;
    }
# ifdef HAS_CIRCLES
    lead(t);
# endif
# ifdef HAS_GRIPS
    stick();
# endif
}

int main(int count, char **words) {
    long steps = count > 1 ? atol(words[1]) : GIVEN_STEPS;
# ifdef HAS_GRIPPED
    for (int g = 0; g < GRIPPED; g++) {
        int k = gripped[g].wall, i = gripped[g].mass;
        grip[k][i].holds = 1, grip[k][i].stretch = gripped[g].stretch, grip[k][i].place = place(k, i);
    }
# endif
    for (long i = 0; i < steps; i++) step();
    for (int i = 0; i < MASSES; i++) printf("%.17g %.17g\n", m[i].x, m[i].y);
    return 0;
}
