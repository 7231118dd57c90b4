package org.pendant.desktop.debug;

/**
 * Value key: what stays the same about a value from one stop to the next.
 *
 * @param expression what yields it in that scope, as the debugger takes it
 */
record ValueKey(Scope scope, String expression) {}
