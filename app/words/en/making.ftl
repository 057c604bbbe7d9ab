# The form in which a lesson is made, for teachers.

making-title = Lesson
making-form = Make a lesson
making-about = A lesson goes step by step beside the body: a question, what to do, the sliders for it. It is part of the scene: save it, download it or make a link of it in the Share tab.
making-fold = Hide
    .unfold = Show
making-done = Done
making-add = Add a step
    .first = Add the first step
making-try = Try this step
making-phone = See as phone
making-drop = Delete lesson
    .hint = Undo brings it back
# A bar while a step is tried; its name, what it says, and its button.
making-trying = Step { $step } as a pupil sees it
    .label = A step is tried
    .back = Back to the form
# Why a change of a step that is not shown was refused, a sentence with its full stop.
making-refused = Step { $step }: { $why } It stays as it was.
# What can be done to a step in the list.
making-up = Move up
making-down = Move down
making-duplicate = Duplicate
making-remove = Remove

# The question of a step.
making-ask = Ask a question first
making-question = Question
making-answers = Answers; the right one is marked
    .add = Add an answer
making-answer = Answer { $number }
    .right = Answer { $number } is right
    .remove = Remove answer { $number }
making-right = This is the right one
making-because = Why that is right

# The fields of a step.
making-step-title = Title
making-do = What to do
making-watch = What to watch meanwhile (may be empty)
making-begins = Begins with
    .take = Begin as it is now
    .saved = The scene as it is saved.
    .now = Now: { $settings }.
making-runs = Runs with, once the question is answered
    .take = Run as it is now
    .drop = Run as it begins
    .same = As it begins.
    .hint = Reset, pause, and change the numbers or drag the masses that the question is about.
# A run in which a mass is led round a circle.
making-lead = Lead this mass round
    .mass = Mass
    .circle = circle (px)
    .turns = turns (Hz)
    .refused = Type the number of a mass, from 0.
making-controls = Pupils get: { $controls }
    .none = Pupils get no sliders
    .gone = { $control }, which does not apply to the scene
making-shows = Shows
making-plots = Plots: { $plots }.
    .take = Plots as they are open now
    .replace = Replace them by the plots that are open now
    .drop = No plots
    .none = No plots.
making-arrows = Arrows: { $arrows }.
    .take = Arrows as they are on now
    .drop = Leave arrows alone
    .none = No arrows.
    .stay = Arrows stay as they are.
making-arrow-forces = forces
making-arrow-velocities = velocities
making-arrow-torques = torques
making-ghost = A second body to compare with
    .none = none
    .reference = Reference
making-class = In a class
    .hint = Click a mass to choose among its quantities.
making-predict = Predict where it is after (s)
making-aims = A goal to reach
making-goal = Goal
    .low = from
    .high = to
    .seconds = for (s)
making-collects = Each one hands in a reading
making-collect = Hand in
# Lists of a quantity, for a screen reader; label: what the quantity is for.
making-part = { $label }: part
    .quantity = { $label }: quantity
    .of = { $label }: of it
# Of a quantity.
making-value = value
making-period = period

# Notices.
making-not-done = That cannot be done
making-in-class = Not in a class
    .text = Open softrod outside the class and make the lesson there; a class can use it afterwards.
