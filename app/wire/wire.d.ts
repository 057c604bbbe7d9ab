// Made by `uv run python -m tests.page.generate` from app/wire.
export type CommandName = "play" | "step" | "steps" | "back" | "forward" | "second" | "before" | "reset" | "pause" | "run" | "forget" | "follow" | "ownBody" | "plot" | "hear" | "hearLive" | "stopwatch" | "energy" | "foretell" | "ownSolver" | "share" | "video" | "picture" | "gallery" | "anew" | "muscle" | "modes" | "mute" | "race" | "leaveRace" | "lesson" | "edit" | "cross" | "undo" | "redo" | "hand" | "build" | "joint" | "select" | "cut" | "pin" | "remove" | "duplicate" | "copy" | "all" | "mirror" | "corners" | "triangulate" | "rest" | "keep" | "stiffen" | "fit" | "chase" | "larger" | "dark" | "meter" | "gizmos" | "palette" | "help" | "access" | "describe" | "describeBody" | "body" | "lengths" | "angles";
/** Texts that are too long for one message. */
export type TextKind = "resume" | "link" | "file" | "rival" | "paste";
/** Commands that the page's script does, by the features that they belong to. */
export type PageCommands = { time: never; lesson: never; play: never; measure: never; instruments: never; fit: never; solver: never; files: "share" | "video" | "picture"; gallery: "gallery"; muscles: never; modes: "mute"; race: "race"; making: never; edit: "edit" | "cross"; view: "fit" | "chase" | "larger" | "palette"; access: "access"; reading: never; describe: "describe"; hands: never };
/** New values of fields of a step, see `sim.scene.lesson.Step`; null removes one. */
export type StepChanges = { title?: string; do?: string; watch?: string; question?: QuestionDraft | null; predict?: number | null; goal?: GoalDraft | null; collect?: ReadingDraft | null; controls?: string[]; plots?: null; arrows?: null; run?: null; ghost?: string };
/** A question as it is written, see `sim.scene.lesson.Question`. */
export type QuestionDraft = { text: string; choices: string[]; answer: number; because: string };
/** A goal as it is written, see `sim.scene.lesson.Goal`. */
export type GoalDraft = { quantity: string; of: "period" | "value"; low: number | null; high: number | null; seconds: number };
/** A reading as it is chosen, see `sim.scene.lesson.Reading`. */
export type ReadingDraft = { quantity: string; of: "period" | "value" };
/** What one seat found: a point of the class's plot. */
export type Found = { setting: number; found: number };
/** The axes of the class's plot, in words. */
export type Axes = { what: string; unit: string; over: string; over_unit: string; turned: boolean };
/** What a class looks at. */
export type Asking = { stop: number; phase: "ask" | "collect" | "explain" | "lobby" | "results" | "reveal" | "run" | "show" | "try"; round: number; title: string; do: string; watch: string; question: string; choices: string[]; right: number; because: string; runs: string; predict: number; masses: number[]; goal: string; collects: string };
/** Something that the pupil at a page has given. */
export type Given = { stop: number; round: number; twin: number; kind: "line" | "prediction" | "vote" | "work"; choice: number; text: string; late: boolean };
/** A slider or a list of a pupil's page. */
export type Dial = { key: string; label: string; unit: string; low: number; high: number; logarithmic: boolean; value: number | string; options: [string, string][]; sets: string[] };
/** A plot of a step. */
export type Curve = { names: string[]; labels: string[]; units: string[]; over: string; over_label: string; over_unit: string; turned: boolean };
/** A line that the teacher has picked out. */
export type WallLine = { text: string; color: string };
/** The power law, found = factor * setting ** exponent, that the class's points are closest to. */
export type Law = { factor: number; exponent: number };
/** What a device found that tried whether it can take part; see `from_page.Checked`. */
export type DeskTried = { trip: number; rate: number; works: boolean; doubts: boolean };
/** A stop of the class's plan. */
export type DeskStop = { title: string; phases: ["ask" | "collect" | "explain" | "lobby" | "results" | "reveal" | "run" | "show" | "try", number][] };
/** A seat, as the teacher sees it. */
export type DeskSeat = { number: number; name: string; color: string; here: boolean; two: boolean; hand: boolean; answered: boolean; doing: "" | "at rest" | "exploded" | "goal reached" | "moving" | "paused" | "untouched"; done: boolean[]; follows: boolean; digits: string };
/** An answer, as the teacher sees it. */
export type DeskAnswer = { id: string; seat: number; kind: "line" | "prediction" | "vote" | "work"; choice: number; text: string; late: boolean; starred: boolean; found: number | null; setting: number | null; reached: boolean | null; doubt: string; places: [number, number][] };
/** A scene that the class could go through: its name, and its title. */
export type LessonName = { name: string; title: string };
/** A scene as the gallery shows it. */
export type Entry = { name: string; title: string; line: string; text: string; group: string; own: boolean; saved: boolean };
/** What the script shows of a step, see `sim.scene.lesson.Step`. */
export type LessonStep = { title: string; do: string; watch: string; question: Question | null; run: boolean };
/** A multiple-choice question. */
export type Question = { text: string; choices: string[]; answer: number; because: string };
/** One step of a lesson. */
export type Step = { title: string; question: Question | null; do: string; watch: string; settings: string[]; run: StepRun; controls: string[]; plots: string[] | null; arrows: ("forces" | "torques" | "velocities")[] | null; ghost: string | null; predict: number | null; goal: Goal | null; collect: Reading | null };
/** What is shown after a step's question: the case that it is about. */
export type StepRun = { settings: string[]; pulls: Pull[]; leads: Lead[]; muscles: RunMuscle[] };
/** A mass that is displaced before a run begins and released as it does. */
export type Pull = { mass: number; by: [number, number] };
/** A mass that is guided during a run, like a moving anchor. */
export type Lead = { mass: number; circle: Circle };
/** The motion of an anchor on a circle. */
export type Circle = { radius: number; frequency: number; ramp: number };
/** A joint's muscle during a run. */
export type RunMuscle = { joint: number; muscle: JointMuscle | null };
/** The muscle of an angular spring: amplitude times the wave is added to its rest angle. */
export type JointMuscle = { phase: number; wave: "pulse" | "sine" | "steady"; per_beat: number; keys: "left-right" | "up-down"; amplitude: number };
/** A goal to be reached: a reading from `low` to `high`, for `seconds` without interruption. */
export type Goal = { quantity: string; of: "period" | "value"; low: number | null; high: number | null; seconds: number };
/** A value read from a run. */
export type Reading = { quantity: string; of: "period" | "value" };
/** A slider or a list that a step can offer. */
export type LessonControl = { key: string; label: string };
/** A line of a plot that is heard. */
export type HeardLine = { name: string; unit: string; bottom: number; top: number; turns: boolean; values: (number | null)[] };
/** Whether less motion is wished: a body that is opened then stands until it is played. */
export type Still = { do: "still"; on: boolean };
/** A slider of the step's is moved. */
export type SetNumber = { do: "setNumber"; key: string; value: number };
/** Something is chosen from a list of the step's. */
export type SetWord = { do: "setWord"; key: string; value: string };
/** One of the choices of a question. */
export type GiveVote = { do: "giveVote"; id: string; turn: number; stop: number; round: number; twin: number; choice: number };
/** Where each mass will be. */
export type GivePrediction = { do: "givePrediction"; id: string; turn: number; stop: number; round: number; twin: number; points: [number, number][] };
/** An explanation. */
export type GiveLine = { do: "giveLine"; id: string; turn: number; stop: number; round: number; twin: number; text: string };
/** Hand in what the page's body did since the step began; the server has it. */
export type GiveWork = { do: "giveWork"; id: string; turn: number; stop: number; round: number; twin: number };
/** A hand goes up or down. */
export type RaiseHand = { do: "raiseHand"; up: boolean };
/** Another name is wanted: one of the class's, or the one that was typed. */
export type NewName = { do: "newName"; wanted?: string };
/** Two pupils are at this page, or one. */
export type SitTogether = { do: "sitTogether"; two: boolean };
/** Another device is to take the seat over: two digits are wanted by which it finds it. */
export type LeaveBy = { do: "leaveBy" };
/** This page is to have the seat that offers itself by two digits. */
export type TakeOver = { do: "takeOver"; digits: string };
/** The page goes to another stop of its homework. */
export type WalkTo = { do: "walkTo"; stop: number };
/** The page is to show the teacher's body where it could show its own, or its own again. */
export type Follow = { do: "follow"; on: boolean };
/** What a device found that tried whether it can take part in a class. */
export type Checked = { do: "checked"; trip: number; rate: number; works: boolean; doubts: boolean };
/** The class goes to a stop and a phase. */
export type Stage = { do: "stage"; stop: number; phase: "ask" | "collect" | "explain" | "lobby" | "results" | "reveal" | "run" | "show" | "try"; round?: number };
/** The class is to go through another scene; before it begins. */
export type ChooseLesson = { do: "chooseLesson"; name: string };
/** Pupils are in the network of one of this computer's addresses. */
export type ChooseNetwork = { do: "chooseNetwork"; address: string };
/** Something that needs no place. */
export type Arrange = { do: "arrange"; what: "again" | "asMine" | "close" | "end" | "gather" | "giveBack" | "givenNames" | "goOn" | "law" | "lessonFile" | "lowerHands" | "noLaw" | "open" | "ownNames" | "pause" | "reset" | "sheet" | "tell" | "zip" };
/** An answer is picked out, or no longer. */
export type Star = { do: "star"; answer: string; on: boolean };
/** An answer is to be shown alone on the wall; none for "". */
export type ToWall = { do: "toWall"; answer: string };
/** Answers that a pupil gave in a file: the text of the file that was saved there, or of its QR code. */
export type Bring = { do: "bring"; text: string };
/** Something is to be done with one seat. */
export type OneSeat = { do: "oneSeat"; seat: number; what: "hide" | "move" | "reset" | "sendAway" | "show" };
/** Describe the part that is selected, or else a mass, or else the body. */
export type Describe = { do: "describe"; mass?: number | null };
/** Say when the body touches something after it was free, or no longer. */
export type FollowTouches = { do: "followTouches"; on: boolean };
/** Change the name and the description of the scene. */
export type SetTexts = { do: "setTexts"; name: string; description: string };
/** Change the frequency of the beat of all muscles, Hz. */
export type Tempo = { do: "tempo"; frequency: number };
/** Select these parts only; or with `toggle`, select or deselect them. */
export type Select = { do: "select"; masses?: number[]; springs?: number[]; joints?: number[]; toggle?: boolean };
/** Select what lies entirely in a rectangle; with `add`, in addition to the selection. */
export type Marquee = { do: "marquee"; x: [number, number]; y: [number, number]; add?: boolean };
/** Add a mass. */
export type Place = { do: "place"; x: number; y: number };
/** Add a spring between two masses; a mass that is not given is added, too. */
export type Line = { do: "line"; a?: number | null; b?: number | null; start?: [number, number]; end?: [number, number] };
/** Add an angular spring between two springs, at rest at their present angle. */
export type Hold = { do: "hold"; a: number; b: number };
/** Set the rest angle of a joint, degrees; by default to its present angle. */
export type Turn = { do: "turn"; joint: number; angle?: number | null };
/** Cut the springs that a stroke crosses. */
export type Stroke = { do: "stroke"; points: [number, number][] };
/** Move the selection, or else one mass; with `rest`, springs and joints rest as they are then. */
export type Move = { do: "move"; x: number; y: number; rest?: boolean; under?: number | null; keys?: boolean };
/** Change phase and amplitude of the selected muscles. */
export type MoveMuscles = { do: "moveMuscles"; later?: number; stretch?: number; turn?: number; keys?: boolean };
/** Change the waveform or the waves per beat of the selected muscles, or spread their phases. */
export type ShapeMuscles = { do: "shapeMuscles"; wave?: "pulse" | "sine" | "steady" | null; per_beat?: number | null; spread?: boolean };
/** Apply an action to a mass; or to the selection, or else to the mass under the pointer. */
export type Act = { do: "act"; what: "all" | "copy" | "corners" | "duplicate" | "keep" | "mirror" | "pin" | "remove" | "rest" | "stiffen" | "triangulate"; mass?: number | null; under?: number | null };
/** A link to the scene, with the present pose or without. */
export type Share = { do: "share"; pose: boolean; page: string; short?: boolean; controls?: "all" | "play" | "sliders" };
/** All scenes, and pictures of the user's own. */
export type ListScenes = { do: "listScenes"; dark: boolean };
/** Open a scene by its name. */
export type OpenScene = { do: "openScene"; name: string };
/** Begin a class with a scene, by its name. */
export type UseInClass = { do: "useInClass"; name: string };
/** Do something with one of the page's own scenes; `name` is that of a deleted one for "restore". */
export type ChangeScene = { do: "changeScene"; how: "delete" | "duplicate" | "rename" | "restore"; name: string; to?: string };
/** The held arrow keys; repeated while there are any. */
export type Keys = { do: "keys"; held: ("down" | "left" | "right" | "up")[] };
/** The places of hands; sent at every animation frame in which one has moved. */
export type At = { do: "at"; hands: [number, number, number][] };
/** A hand grabs a mass. */
export type Grab = { do: "grab"; hand: number; mass: number; x: number; y: number };
/** A hand releases its mass. */
export type Drop = { do: "drop"; hand: number };
/** A mass was clicked. */
export type Pick = { do: "pick"; mass: number };
/** The page goes to a step of the scene's lesson. */
export type BeginStep = { do: "beginStep"; step: number; how?: "on" | "run" | "wait" };
/** Open or close the form of the lesson. */
export type MakeLesson = { do: "makeLesson"; on: boolean };
/** Insert a step at a position, counted from 0. */
export type AddStep = { do: "addStep"; at: number };
/** Insert a copy after a step. */
export type CopyStep = { do: "copyStep"; step: number };
/** Remove a step; with the last one, the lesson. */
export type RemoveStep = { do: "removeStep"; step: number };
/** Move a step to another position. */
export type MoveStep = { do: "moveStep"; step: number; to: number };
/** Change fields of a step. */
export type ChangeStep = { do: "changeStep"; step: number; changes: StepChanges };
/** Give a step the present settings, plots or arrows, or have it run the body as it is now. */
export type TakeInStep = { do: "takeInStep"; step: number; what: "arrows" | "plots" | "run" | "settings" };
/** Have the run of a step lead a mass round a circle; none for a radius of 0. */
export type LeadInStep = { do: "leadInStep"; step: number; mass: number; radius: number; frequency: number };
/** Begin a step as a pupil sees it. */
export type TryStep = { do: "tryStep"; step: number };
/** Return from a step that was begun by `TryStep`. */
export type EndTrying = { do: "endTrying" };
/** Remove the lesson. */
export type DropLesson = { do: "dropLesson" };
/** The Measure tab is shown for the first time: it is to begin with a plot. */
export type FirstPlot = { do: "firstPlot" };
/** Which part of a plot over time is in view now. */
export type InView = { do: "inView"; plot: string; part: [number, number] | null };
/** In which tab somebody sees plots now; they are not sent otherwise. */
export type Seen = { do: "seen"; tab: "" | "lesson" | "measure" };
/** Put the body into a mode, with a part of the amplitude of a full bar. */
export type PutMode = { do: "putMode"; mode: number; part: number };
/** Drive a mode while a bar is pressed; stop driving (-1) when it is released. */
export type DriveMode = { do: "driveMode"; mode: number };
/** The card was closed. */
export type CloseCard = { do: "closeCard" };
/** Show a moment of the past, s. */
export type GoTo = { do: "goTo"; time: number };
/** Set the speed, simulated seconds per second. */
export type Speed = { do: "speed"; speed: number };
/** Execute a command of the table, see `app.ui.commands`. */
export type Perform = { do: "perform"; command: CommandName };
/** A slider or a number box was focused: later changes are another step of undo. */
export type Visit = { do: "visit" };
/** A text was too long to be sent, for a notice to the user. */
export type Unsent = { do: "unsent"; what: TextKind };
/** Identifies the page's user: a secret of the browser, and the owner's key if it was opened with that. */
export type Who = { do: "who"; visitor: string; owner?: string; teacher?: string };
/** A part of a text that is too long for one message. */
export type Part = { do: "part"; kind: TextKind; number: number; of: number; letters: string };
export type FromPage = Still | SetNumber | SetWord | GiveVote | GivePrediction | GiveLine | GiveWork | RaiseHand | NewName | SitTogether | LeaveBy | TakeOver | WalkTo | Follow | Checked | Stage | ChooseLesson | ChooseNetwork | Arrange | Star | ToWall | Bring | OneSeat | Describe | FollowTouches | SetTexts | Tempo | Select | Marquee | Place | Line | Hold | Turn | Stroke | Move | MoveMuscles | ShapeMuscles | Act | Share | ListScenes | OpenScene | UseInClass | ChangeScene | Keys | At | Grab | Drop | Pick | BeginStep | MakeLesson | AddStep | CopyStep | RemoveStep | MoveStep | ChangeStep | TakeInStep | LeadInStep | TryStep | EndTrying | DropLesson | FirstPlot | InView | Seen | PutMode | DriveMode | CloseCard | GoTo | Speed | Perform | Visit | Unsent | Who | Part;
/** What a pupil's page has to know of the class. */
export type Seat = { tell: "seat"; code: string; problem: string; name: string; color: string; turn: number; two: boolean; hand: boolean; types_name: boolean; is_given: boolean; digits: string; follows: boolean; gathered: boolean; paused: boolean; away: boolean; on_wall: boolean; elsewhere: "" | "device" | "page"; reached: boolean; reading: string; found: Found[]; own: Found | null; axes: Axes; home: string; told: boolean; done: boolean[]; asking: Asking | null; given: Given[] };
/** What a pupil has to work with: sliders, plots, and arrow keys. */
export type Bench = { tell: "bench"; opening: number; dials: Dial[]; curves: Curve[] };
/** A body with which a page goes on where its connection ends. */
export type Alone = { tell: "alone"; opening: number; body: string; method: string; dt: number };
/** What the class sees in front; no name is in it. */
export type Wall = { tell: "wall"; code: string; address: string; qr: string; seats: number; answered: number; asking: Asking; bars: number[]; lines: WallLine[]; alone: boolean; paused: boolean; found: Found[]; axes: Axes; law: Law | null; doing: Record<string, number>; start: [number, number][]; steps: number; unit: string };
/** Where the class has said that the masses will be, in the page's world: one body a prediction, without names. */
export type Predictions = { tell: "predictions"; bodies: [number, number][][] };
/** Where bodies are: thousandths of the scene's frame from its left and upper edge. */
export type Posters = { tell: "posters"; places: Record<string, [number, number][]>; start: [number, number][]; springs: [number, number][] };
/** What the teacher's page has to know of the class. */
export type Desk = { tell: "desk"; code: string; address: string; qr: string; check: string; check_qr: string; tried: DeskTried[]; stops: DeskStop[]; asking: Asking; next: [number, "ask" | "collect" | "explain" | "lobby" | "results" | "reveal" | "run" | "show" | "try", number] | null; seats: DeskSeat[]; answers: DeskAnswer[]; bars: number[]; doing: Record<string, number>; right: number; axes: Axes; law: Law | null; shows_law: boolean; on_wall: string; seat_on_wall: number; gathered: boolean; again: "no" | "now" | "yes"; open: boolean; own_names: boolean; paused: boolean; saved: boolean; trouble: string; lessons: LessonName[]; lesson: string; networks: string[]; home: string; told: boolean; done: [number, number][]; elapsed: number };
/** Something that the user of the page is to read once. */
export type Remark = { tell: "remark"; title: string; text: string };
/** The server has these answers, or has refused one: then it says why. */
export type Taken = { tell: "taken"; ids: string[]; refused: string };
/** What became of answers that the teacher brought, in a sentence. */
export type Brought = { tell: "brought"; told: string; refused: boolean };
/** The class is over: nothing of it is to be kept. */
export type ClassEnded = { tell: "classEnded" };
/** What the plots of a page show now. */
export type Readings = { tell: "readings"; numbers: Float32Array };
/** The body touches something after it was free. */
export type Touched = { tell: "touched"; by: "body" | "floor" | "wall" };
/** What the body, or a part of it, is like, in words. */
export type Described = { tell: "described"; text: string };
/** The selection. */
export type Selected = { tell: "selected"; masses: number[]; springs: number[]; joints: number[] };
/** Names of the changes that can be undone and redone; empty for none. */
export type Versions = { tell: "versions"; undo: string; redo: string; count: number; stiffen: number };
/** The copied parts, as text. */
export type Copied = { tell: "copied"; text: string };
/** The result of `SetTexts`: a sentence that says why it was refused, or an empty one. */
export type TextsTaken = { tell: "textsTaken"; refused: string };
/** A link to the scene. */
export type Link = { tell: "link"; link: string; qr: string; problem: string };
/** The measured places of a table: time, x and y of each; empty without a table. */
export type Measured = { tell: "measured"; numbers: Float32Array };
/** Bodies that fit the table about as well as the fitted one: (frames, draws, masses, 2) places, px, from time 0 on; empty without a fit. */
export type Fan = { tell: "fan"; numbers: Float32Array; draws: number; masses: number; rate: number };
/** Show the gallery, and why. */
export type OfferGallery = { tell: "offerGallery"; why: string };
/** Scenes were saved, renamed or deleted. */
export type ShelfChanged = { tell: "shelfChanged" };
/** All scenes, and the name of the present one. */
export type Scenes = { tell: "scenes"; scenes: Entry[]; present: string; teaches: boolean };
/** Pictures of scenes by their names, as addresses that an image can have. */
export type ScenePictures = { tell: "scenePictures"; pictures: Record<string, string> };
/** What was done with a scene of the page's own. */
export type SceneChanged = { tell: "sceneChanged"; text: string; undo: string };
/** How a scene is used in a class. */
export type UsedInClass = { tell: "usedInClass"; address: string; command: string };
/** What is measured on the canvas. */
export type Tools = { tell: "tools"; traced: number[]; seconds: number; chosen: number; coordinates: boolean; strobe: number };
/** Another scene was opened: the instruments on the canvas go back into the box. */
export type PutBack = { tell: "putBack" };
/** Forces, velocities and torques; empty while no arrows are shown. */
export type Arrows = { tell: "arrows"; numbers: Float32Array };
/** The scene's lesson, which may be anyone's: the script shows it as text only. */
export type Lesson = { tell: "lesson"; name: string; steps: LessonStep[] };
/** The lesson that is being edited. */
export type LessonForm = { tell: "lessonForm"; open: boolean; trying: number; steps: Step[]; begins: string[]; runs: string[]; plots: string[] };
/** What the user can choose for a step at present. */
export type LessonOffers = { tell: "lessonOffers"; parts: Record<string, string>; quantities: Record<string, Record<string, string>>; controls: LessonControl[]; methods: Record<string, string>; settings: string; plots: string[]; arrows: string[] };
/** The result of a change of the lesson. */
export type LessonTaken = { tell: "lessonTaken"; step: number; part: string; field: string; refused: string };
/** The newest values of the plot that is heard while the body moves. */
export type Tones = { tell: "tones"; plot: string; time: number; lines: HeardLine[] };
/** Turn to the Measure tab, where a plot is about to appear. */
export type ShowMeasures = { tell: "showMeasures" };
/** Play a plot as a melody. */
export type Melody = { tell: "melody"; plot: string; number: number; count: number; way: "frequency" | "path" | "time"; moments: number[]; lines: HeardLine[] };
/** The slow vibrations of the body, while the strip of modes is open. */
export type Modes = { tell: "modes"; on?: boolean; number?: number; trouble?: string; frequencies?: number[]; damping?: number[]; full?: number[]; driven?: number };
/** Shapes of the modes, see `modes.feature.encode_shapes`; empty while the strip is closed. */
export type ModeShapes = { tell: "modeShapes"; numbers: Float32Array };
/** How much of each mode is in the present motion, see `modes.feature.encode_levels`. */
export type ModeLevels = { tell: "modeLevels"; numbers: Float32Array };
/** The race of the body against others, if there is one. */
export type Race = { tell: "race"; on?: boolean; names?: string[]; ways?: number[]; seconds?: number; fair?: boolean; finish?: number; lines?: number[]; arrived?: (number | null)[]; outs?: ("" | "away" | "exploded" | "fell" | "late" | "misfit")[]; masses?: number[]; more?: boolean };
/** Whether a race begins: why not, in a sentence, or an empty text. */
export type RaceAnswer = { tell: "raceAnswer"; problem: string };
/** What the card beside a mass says. */
export type MassCard = { tell: "massCard"; mass: number; joint: number; title: string; rows: [string, string][] };
/** The state of the session and of the page. */
export type PageState = { tell: "pageState"; page: string; scene: number; title: string; width: number; height: number; view?: number[]; unit: string; joint?: number; playing?: boolean; rest?: boolean; scrubbed?: boolean; start?: number; end?: number; speed?: number; offer?: boolean; future?: boolean; follow?: boolean; arrows?: string[]; broken?: number; controls?: string[]; gizmos?: boolean; meter?: boolean; measuring?: string; lesson?: boolean | null };
/** The head-up display over the canvas, HTML. */
export type Hud = { tell: "hud"; html: string };
/** The state that the browser stores and returns after a reload or an outage, see `keeping`: JSON. */
export type Keepsake = { tell: "keepsake"; kept: string };
/** What viser's messages lack of a control of the panel. */
export type ControlLook = { tell: "controlLook"; id: string; unit?: string; low?: number | null; high?: number | null; logarithmic?: boolean; own?: number | null; place?: "" | "below" | "beside" | "card"; note?: string; picture?: string };
/** Execute a command of the page's script, see `app.ui.commands`. */
export type Run = { tell: "run"; command: CommandName };
/** The server has received the saved state. */
export type Resumed = { tell: "resumed" };
/** The parts and the surroundings of a body. */
export type Plan = { tell: "plan"; numbers: Float32Array };
/** The plan of a second body; the positions of its masses are in the frames. */
export type SecondPlan = { tell: "secondPlan"; numbers: Float32Array };
/** The positions of the masses. */
export type Frame = { tell: "frame"; numbers: Float32Array; wall: number };
/** Yielded and broken springs; sent only when that changes. */
export type Damage = { tell: "damage"; numbers: Float32Array };
export type ToPage = Seat | Bench | Alone | Wall | Predictions | Posters | Desk | Remark | Taken | Brought | ClassEnded | Readings | Touched | Described | Selected | Versions | Copied | TextsTaken | Link | Measured | Fan | OfferGallery | ShelfChanged | Scenes | ScenePictures | SceneChanged | UsedInClass | Tools | PutBack | Arrows | Lesson | LessonForm | LessonOffers | LessonTaken | Tones | ShowMeasures | Melody | Modes | ModeShapes | ModeLevels | Race | RaceAnswer | MassCard | PageState | Hud | Keepsake | ControlLook | Run | Resumed | Plan | SecondPlan | Frame | Damage;
/** What is in arrays of numbers, by the tags of their messages. */
export type Layouts = {
  readings: {
    /** of the body, as in `Bench` */ opening: number;
    /** simulated seconds */ time: number;
    /** of each plot the quantities, and the one on the horizontal axis */ values: Float32Array;
  };
  arrows: {
    /** of the body */ generation: number;
    /** simulated seconds */ time: number;
    /** every how manyth mass has an arrow; held ones always have */ step: number;
    /** every how manyth joint */ jointStep: number;
    /** negligible force, speed and torque */ least: Float32Array;
    /** masses that are held */ held: Float32Array;
    /** x and y of each */ forces: Float32Array;
    /** x and y of each */ velocities: Float32Array;
    /** one each */ torques: Float32Array;
  };
  plan: {
    /** which body this is; frames carry the same number */ generation: number;
    /** from px to the page's world */ scale: number;
    /** the middle of the scene's frame, px */ x: number;
    /** the middle of the scene's frame, px */ y: number;
    /** -1 where y grows downwards */ flip: number;
    /** whether there are so many masses that they are drawn with less */ many: boolean;
    /** whether springs are bars instead of coils */ bars: boolean;
    /** triangles of a wedge */ slices: number;
    /** the mass that the pointer drives, or -1 */ driven: number;
    /** of each mass, in the world */ radius: Float32Array;
    /** two masses each */ springs: Float32Array;
    /** px, one for each spring */ restLength: Float32Array;
    /** amplitude of the coil or width of the bar, in the world */ thickness: Float32Array;
    /** relative stretch at which each spring has its full colour; or one for all */ fullStrain: Float32Array;
    /** spring a, spring b, the mass at the tip, and whether b leaves it (1) or not (-1) */ joints: Float32Array;
    /** degrees */ restAngle: Float32Array;
    /** the held masses that have a support */ pinned: Float32Array;
    /** three a mass: of rim, fill and shine */ massColors: Float32Array;
    /** a table, from full compression to full stretch */ strainColors: Float32Array;
    /** a table, from the full negative deviation to the full positive one */ turnColors: Float32Array;
    /** of pins, ring, ghost and the mark of springs that have yielded */ inkColors: Float32Array;
    /** of each a point of the surface, px, and the unit vector to the free side */ walls: Float32Array;
    /** of each wall px/s to the right of its normal on the screen; nothing if none runs */ belts: Float32Array;
    /** of each a point, px, and a unit vector across it */ rails: Float32Array;
    /** of each whether it is a gas, how many masses its loop has, and which */ fillings: Float32Array;
    /** velocity, px/s; of each wave of its gusts wave vector, amplitude and phase; or nothing */ wind: Float32Array;
    /** px, the distance at which contact begins; 0 where there is none */ contact: number;
    /** the springs that only pull */ ropes: Float32Array;
    /** the springs that only push */ buffers: Float32Array;
    /** of each joint that acts on one side which it is, and 1 above or -1 below its rest angle */ stops: Float32Array;
    /** of each constant force which mass it acts on, and its arrow, in the world */ loads: Float32Array;
    /** frequency, Hz, and phase of the beat, and of each muscle what swing.js says; or nothing */ muscles: Float32Array;
    /** a table, from a muscle at its longest to one at its shortest */ muscleColors: Float32Array;
    /** whether the body is in a medium */ medium: boolean;
    /** whether it lies on the ground, seen from above */ ground: boolean;
    /** of each its joint, the sign of its speed, its keys: 0 Left and Right, 1 Up and Down, -1 none */ motors: Float32Array;
    /** of each force that keys work its mass, its arrow, in the world, and its keys */ pushes: Float32Array;
  };
  frame: {
    /** of the body */ generation: number;
    /** simulated seconds */ time: number;
    /** factor of all rest lengths */ lengthScale: number;
    /** degrees added to all rest angles */ angleShift: number;
    /** what a time in single precision lacks, s */ timeRest: number;
    /** px, x and y of each mass */ positions: Float32Array;
    /** px, of a second body with the same plan */ ghost: Float32Array;
    /** of a second body with a plan of its own: time, length_scale, angle_shift, time_rest */ secondMoment: Float32Array;
    /** px, x and y of each of its masses */ secondPositions: Float32Array;
    /** of Left and Right, of Up and Down: from -1 to 1; nothing where none was held */ efforts: Float32Array;
    /** as `efforts`, of a second body with a plan of its own */ secondEfforts: Float32Array;
  };
  damage: {
    /** of the body */ generation: number;
    /** the springs that are broken */ broken: Float32Array;
    /** px by which each rest length has moved for good; empty if none has */ setLength: Float32Array;
    /** degrees by which each rest angle has moved for good; empty if none has */ setAngle: Float32Array;
    /** the broken springs of a second body with the same plan */ ghostBroken: Float32Array;
    /** as `broken`, of a second body with a plan of its own */ secondBroken: Float32Array;
    /** as `set_length`, of that */ secondSetLength: Float32Array;
    /** as `set_angle`, of that */ secondSetAngle: Float32Array;
  };
};
/** Messages to the page, by their tags. */
export type Received = { seat: Seat; bench: Bench; alone: Alone; wall: Wall; predictions: Predictions; posters: Posters; desk: Desk; remark: Remark; taken: Taken; brought: Brought; classEnded: ClassEnded; readings: Readings; touched: Touched; described: Described; selected: Selected; versions: Versions; copied: Copied; textsTaken: TextsTaken; link: Link; measured: Measured; fan: Fan; offerGallery: OfferGallery; shelfChanged: ShelfChanged; scenes: Scenes; scenePictures: ScenePictures; sceneChanged: SceneChanged; usedInClass: UsedInClass; tools: Tools; putBack: PutBack; arrows: Arrows; lesson: Lesson; lessonForm: LessonForm; lessonOffers: LessonOffers; lessonTaken: LessonTaken; tones: Tones; showMeasures: ShowMeasures; melody: Melody; modes: Modes; modeShapes: ModeShapes; modeLevels: ModeLevels; race: Race; raceAnswer: RaceAnswer; massCard: MassCard; pageState: PageState; hud: Hud; keepsake: Keepsake; controlLook: ControlLook; run: Run; resumed: Resumed; plan: Plan; secondPlan: SecondPlan; frame: Frame; damage: Damage };
