// @ts-check
/** What a body needs to go on in the page: the physics of live files, which is loaded once a pupil has a body. */
import { Body } from "../../export/live/static/body.js";
import { Clock } from "../../export/live/static/clock.js";
import { measure } from "../../export/live/static/quantities.js";
import { write } from "../../export/live/static/settings.js";

export const physics = { Body, Clock, measure, write };
