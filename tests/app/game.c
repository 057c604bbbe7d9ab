// What a game does with a body in C: several of them, copies, blows, walls that move, and what is drawn.
#include "body.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void expect(int holds, const char *what) {
    if (!holds) printf("not so: %s\n", what), exit(1);
}

static void count(body *b, void *data) {
    (void)b;
    ++*(int *)data;
}

int main(void) {
    static body one, other, copy;
    memset(&one, 255, sizeof one);  // whatever was there
    body_reset(&one), body_reset(&other);
    expect(!memcmp(&one, &other, sizeof one), "a body that is reset is as at first");

    int steps = 0;
    one.before_step = count, one.data = &steps;
    expect(body_advance(&one, 0.1), "it has not run away");
    expect(steps == (int)floor(0.1 / BODY_DT + 1e-9), "it is called before each step");
    expect(fabs(one.time + one.owed - 0.1) < 1e-12, "no time is lost");
    expect(other.time == 0.0, "another body is another one");

    copy = one;
    for (int i = 0; i < 20; i++) body_advance(&one, 1.0 / 144.0), body_advance(&copy, 1.0 / 144.0);
    expect(one.mass[1].x == copy.mass[1].x && one.mass[1].y == copy.mass[1].y, "a copy goes the same way");
    body_impulse(&copy, 1, 3.0, 4.0);
    expect(fabs(copy.mass[1].vx - one.mass[1].vx - 3.0 / one.mass[1].mass) < 1e-9, "a blow is by the mass");
    body_impulse(&copy, 0, 3.0, 4.0);
    expect(copy.mass[0].vx == 0.0, "what is held stays");

    // What is drawn is between the last two steps.
    double x, y;
    one.owed = 0.25 * BODY_DT;
    body_shown(&one, 1, &x, &y);
    expect(fabs(x - (0.75 * one.mass[1].old_x + 0.25 * one.mass[1].x)) < 1e-9, "it is between them");

    double before = one.time;
    body_advance(&one, 3600.0);
    expect(one.time - before < BODY_LONGEST + 2.0 * BODY_DT, "it does not catch up for ever");
    before = one.time;
    for (int i = 0; i < 20; i++) body_advance(&one, NAN), body_advance(&one, -1.0);
    expect(one.time == before, "no time is none");

    // A floor is raised with what lies on it, and lets go of what it held.
    body_reset(&other);
    for (int i = 0; i < 600; i++) body_advance(&other, 1.0 / 60.0);
    double low = other.mass[BODY_MASSES - 1].y, floor_at = other.wall[0].y;
    for (int i = 0; i < 200; i++) {
        body_move_wall(&other, 0, other.wall[0].x, floor_at - 0.1 * i);
        body_advance(&other, 1.0 / 60.0);
    }
    expect(fabs(other.mass[BODY_MASSES - 1].y - low + 20.0) < 2.0, "what lies on it goes up with it");

    other.mass[1].held = 1, other.mass[2].fx = 1e300;
    for (int i = 0; i < 600; i++) {
        if (!body_advance(&other, 0.1)) return puts("ok"), 0;
    }
    return puts("it has not run away"), 1;
}
