// GIVEN_ABOUT
#ifndef SOFTBODY_H
#define SOFTBODY_H

#ifdef __cplusplus
extern "C" {
#endif
# ifdef TEMPLATE
// What stands for a scene's numbers while these files are compiled as they are.
// `app/export/body/program.py` fills them.
#define GIVEN_MASS_COUNT 1
#define GIVEN_SPRING_COUNT 1
#define GIVEN_JOINT_COUNT 1
#define GIVEN_WALL_COUNT 1
#define GIVEN_DT 0.001

# endif
#define SOFTBODY_DT GIVEN_DT  // length of a time step, s
#define SOFTBODY_LONGEST 0.25  // most that one call of softbody_advance does, s; the rest is left out
enum {
    SOFTBODY_MASSES = GIVEN_MASS_COUNT,
# ifdef HAS_SPRINGS
    SOFTBODY_SPRINGS = GIVEN_SPRING_COUNT,
# endif
# ifdef HAS_JOINTS
    SOFTBODY_JOINTS = GIVEN_JOINT_COUNT,
# endif
# ifdef HAS_WALLS
    SOFTBODY_WALLS = GIVEN_WALL_COUNT,
# endif
};

typedef struct {
    double x, y;    // where the mass is, px
    double vx, vy;  // its velocity, px/s
    double mass;    // kg
    int held;       // 1: it stays where it is put
    double fx, fy;  // a force on it, until that is another one, kg px/s^2
    double ax, ay;  // its acceleration in the last step, px/s^2
    double old_x, old_y;  // where it was before the last step, px
} softbody_mass;

# ifdef HAS_SPRINGS
typedef struct {
    int a, b;     // masses at the ends of the spring
    double k;     // stiffness, kg/s^2
    double rest;  // rest length, px
# ifdef HAS_SPRING_SIDES
    int side;     // 1: it only pulls; -1: it only pushes; 0: both
# endif
# ifdef HAS_DAMPING
    double c;     // damping, kg/s
# endif
# ifdef HAS_JOINTS
    double x, y, length;  // in the last step: its vector and length, px
    double fx, fy;        // and the force on mass b, kg px/s^2
# ifdef HAS_TURNING
    double rx, ry;        // and how fast the vector changed, px/s
# endif
# endif
} softbody_spring;

# endif
# ifdef HAS_JOINTS
typedef struct {
    int p, q;     // springs of the joint
    double k;     // stiffness, kg/s^2
# ifdef HAS_ANGLE_LAW
    double rest;  // rest angle, radians
# else
    double cosine, sine;  // of the rest angle
# endif
# ifdef HAS_JOINT_SIDES
    int side;     // 1: it acts above its rest angle only; -1: below it only; 0: both
# endif
# ifdef HAS_JOINT_DAMPING
    double c;     // damping, kg/s
# endif
} softbody_joint;

# endif
# ifdef HAS_WALLS
typedef struct {
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
# ifdef HAS_BELTS
    double speed;     // of its surface along (-ny, nx), px/s
# endif
# ifdef HAS_STATIC
    double still;     // coefficient of static friction; one below `friction` counts as that
# endif
} softbody_wall;

# ifdef HAS_GRIPS
typedef struct {
    int holds;       // there is a tangential spring between a wall and a mass
    double stretch;  // px
    double place;    // where along the wall the mass was when it had this stretch, px
# ifdef HAS_STATIC
    int slides;      // static friction has been too small, and the mass has not turned round since
# endif
} softbody_grip;

# endif
# endif
// A body. There may be as many as one likes; a copy by `=` is a body of its own, with the same before_step
// and data. What its arrays hold is in the order of the scene. More numbers in here may be changed
// between steps.
typedef struct softbody softbody;
struct softbody {
    double time;  // s
    double owed;  // time that softbody_advance has not done yet, s
# ifdef HAS_GRAVITY
    double gravity_x, gravity_y;  // px/s^2
# endif
# ifdef HAS_AIR
    double air;  // air friction, GIVEN_AIR_UNIT
# endif
# ifdef HAS_WIND
    double wind_x, wind_y;  // velocity of the air, px/s
# endif
# ifdef HAS_STEERING
    double steer[2];  // what keys do, each from -1 to 1: to the right, and up
# endif
# ifdef HAS_EFFORTS
    double effort[2];  // with which keys work muscles: they follow `steer` with a time constant of 0.05 s
# endif
    softbody_mass mass[SOFTBODY_MASSES];
# ifdef HAS_SPRINGS
    softbody_spring spring[SOFTBODY_SPRINGS];
# endif
# ifdef HAS_JOINTS
    softbody_joint joint[SOFTBODY_JOINTS];
# endif
# ifdef HAS_WALLS
    softbody_wall wall[SOFTBODY_WALLS];
# ifdef HAS_GRIPS
    softbody_grip grip[SOFTBODY_WALLS][SOFTBODY_MASSES];
# endif
# endif
    void (*before_step)(softbody *, void *);  // called before each step, or NULL
    void *data;                               // what it is given
};

// Puts a body at its start, without a call before steps. To be called first.
void softbody_reset(softbody *body);

// Does one time step.
void softbody_step(softbody *body);

// Goes on by some time, s: as many steps as fit into it, the rest being kept for the next call.
// Returns 0 once the body has run away, which no longer ends.
int softbody_advance(softbody *body, double seconds);

// The place of a mass at the time that was asked for, between the last two steps, px: what is drawn.
void softbody_shown(const softbody *body, int mass, double *x, double *y);

// Strikes a mass: a momentum, kg px/s.
void softbody_impulse(softbody *body, int mass, double px, double py);

# ifdef HAS_WALLS
// Moves a wall, so that it goes through (x, y); it lets go of what it held.
void softbody_move_wall(softbody *body, int wall, double x, double y);

# endif
#ifdef __cplusplus
}
#endif
#endif
