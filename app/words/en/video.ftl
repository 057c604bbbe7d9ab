# The page on which a video becomes a table.

video-title = softrod: places in a video
video-heading = Places in a video
video-about = Mark up to three points in the frames of a short video, and get a table of time and places. The video stays in this browser; nothing of it is sent.
# Before a button of the browser's.
video-drop = Drop a video here, or choose one:
video-frame = The frame; a click marks a place
video-back = One frame back
video-on = One frame on
video-slider = Frame
# Beside the slider: which frame is shown, and at what time.
video-where = { $frame } of { $count }, { $time } s
# Before a box for the number.
video-rate = frames a second
# Buttons that choose what a click marks; name: a text box beside the button.
video-tools = What a click marks
video-point = Point { $number }
    .name = Name of point { $number } in the table
video-ruler = Ruler
    .other = Click the other end of the ruler.
    .length = Say below how long the ruler is.
video-origin = Origin
video-follow = Follow
    .stop = Stop
video-forget = Forget all places
# Before boxes for the length of the ruler and its unit.
video-length = ruler
video-unit = unit
# Before a choice.
video-direction = y grows
    .down = downwards
    .up = upwards
video-save = Download the table (CSV)
# What happens.
video-unknown = { $name }: this browser cannot show it as a video
video-playing = Its first frames are played, to find how many come in a second ...
video-found = It has { $rate } frames a second; if it does not, correct that next to the slider. Then click a point in the frame. Follow looks for it in the next ones.
    .not = This browser does not report how many frames come in a second: enter it next to the slider. Then click a point in the frame. Follow looks for it in the next ones.
video-mark-first = Mark a point in this frame first.
video-plain = { $name }: there is nothing to recognise within { $count } pixels, or it is too near to the edge.
video-lost = { $name } is lost in frame { $frame }: click it there, and follow on.
video-followed = Followed.
video-none = Mark a point first.
video-no-length = The ruler has no length.
video-saved = Saved. Drop the file on the page with the body to see it there and to fit it.
    .pixels = Saved in pixels: no ruler was drawn. Drop the file on the page with the body to see it there and to fit it.
