// Known and then unknown, over a line break inside a comment. [born-wolf-1999, section 1.5;
// nobody-1900, eq. 1]
