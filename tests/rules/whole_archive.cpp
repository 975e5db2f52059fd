// The test is that this links: tests/rules/CMakeLists.txt takes every object of every library.
int main()
{
    return 0;
}
