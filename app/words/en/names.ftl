### Names that a class gives its pupils, as in "Blue Heron".

seat-name = { $color } { $animal }
# One a line: ten colours in this order, with the same gender as all animals.
seat-colors =
    Red
    Orange
    Golden
    Green
    Teal
    Blue
    Violet
    Pink
    Brown
    Grey
# One a line, each a single word that offends nobody; they need not be the English ones, but at least 45.
seat-animals =
    Badger
    Bear
    Beaver
    Bison
    Camel
    Crane
    Deer
    Dolphin
    Eagle
    Falcon
    Finch
    Fox
    Gecko
    Hare
    Hedgehog
    Heron
    Horse
    Ibex
    Kiwi
    Koala
    Lark
    Lion
    Lynx
    Magpie
    Marten
    Mole
    Moose
    Newt
    Otter
    Owl
    Panda
    Penguin
    Puffin
    Raven
    Robin
    Salmon
    Seal
    Swan
    Tiger
    Turtle
    Walrus
    Wolf
    Wren
    Yak
    Zebra
