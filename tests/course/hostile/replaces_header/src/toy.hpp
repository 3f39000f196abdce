#define square cube
