# The card of a lesson, one step at a time; in the page and in live files.

lesson-card = Lesson
lesson-right = That is right.
lesson-answer = The answer is: { $choice }.
# Of the steps; $at is the present one.
lesson-count = { $at } of { $count }
lesson-check = Check my answer
lesson-next = Next step
    .first = Back to step 1
# Before what is to be done, and what is to be watched.
lesson-do = Do:
lesson-watch = Watch:
lesson-back = Back
lesson-again = Start again
    .hint = begin this step again
lesson-fails = This step cannot begin
# While a class goes through a lesson, its answers are not shown elsewhere.
lesson-closed = A class goes through this lesson now
    .text = Here is its body alone; the steps come with the class.
