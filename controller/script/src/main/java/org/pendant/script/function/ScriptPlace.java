package org.pendant.script.function;

/**
 * Script location: what a program was at.
 *
 * @param source name of the text: the program's, or {@code interpreter}
 * @param thread handle of the script thread, 0 for the main thread
 * @param threadName name of the function that the thread began with
 * @param line 1-based line that the thread had reached in that text
 */
public record ScriptPlace(String source, int thread, String threadName, int line) {}
