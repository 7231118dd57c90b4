/**
 * Interpreter mode port: a line of statements is acknowledged under a number or discarded with a
 * reason, and everything acknowledged goes to log files. Open {@link
 * org.pendant.protocols.interpreter.InterpreterServer} first.
 */
package org.pendant.protocols.interpreter;
