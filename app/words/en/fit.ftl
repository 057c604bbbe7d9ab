# The scene is fitted to a table of what was measured: in the Measure tab.

# Holds a link.
fit-about = A table that is dropped on the page is drawn over the body, and the scene can be fitted to it. { $link } makes one.
    .link = Measure in a video
# $name: of the table.
fit-table = { $count ->
   *[other] <b>{ $name }</b>: { $count } rows. Which quantity is each column?
}
fit-run = Run
# In a text box for each column.
fit-column = as mass1.x, -mass1.y, 90 - spring0.direction or a formula; empty to leave it out
fit-scale = { $unit } to a metre
    .hint = how large one metre of the table is in the scene
fit-sought = What is sought?
fit-start = Start (places, velocities)
fit-origin = Origin of the table
fit-length-scale = Length scale
fit-fit = Fit
fit-forget = Forget the table
# While it is being fitted; $what: how far it has come.
fit-begins = The fit begins ...
fit-goes-on = Fitting: { $what } ...
fit-cannot = <b>It cannot be fitted</b>: { $why }.
fit-error = There was an error on the server.
# Why it cannot be fitted.
fit-no-table = there is no table
fit-many-masses = a page fits at most { $count } masses; softrod fit takes more
fit-many-numbers = a page fits at most { $count } numbers; softrod fit takes more
fit-no-scale = write how many { $unit } of the scene are one metre, 0.000001..1e9, or seek the length scale
fit-choose = choose from 1 to { $most } numbers that are sought, not { $count }
fit-compiling = the solver is still being compiled; try again in a moment
fit-changed = the scene was changed meanwhile; fit it again
# What a fit does not explain of a column.
fit-left = { $column }: what is left is { $noise }.
