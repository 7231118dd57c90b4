package org.pendant.script.vm;

/**
 * Interpreter status: what interpreter mode is at (manual 13.7). Ids are those that lines were
 * accepted under; 0 where there is none yet.
 *
 * @param active whether a program waits in {@code interpreter_mode()}
 * @param lastExecuted id of the newest line whose execution has begun
 * @param lastInterpreted id of the newest line that was accepted
 * @param lastCleared id of the newest line that was cleared
 * @param unexecuted how many accepted lines wait for their execution
 */
public record InterpreterStatus(
    boolean active, int lastExecuted, int lastInterpreted, int lastCleared, int unexecuted) {}
