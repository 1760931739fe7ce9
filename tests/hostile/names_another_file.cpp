// Has the compiler show a line of a file that it never reads.
#line 1 "/etc/passwd"
int wrong = ;
