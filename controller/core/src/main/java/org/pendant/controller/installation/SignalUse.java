package org.pendant.controller.installation;

import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;

/**
 * Signal use: what a signal is called and does; signals that are not mentioned have no name and do
 * nothing.
 *
 * @param signal such as {@code digital_in[0]}, {@code analog_out[1]} or {@code flag[3]}
 * @param name for people; empty for none
 * @param input what a high level does; only for digital inputs
 * @param output what programs do to it when they start and end; only for digital outputs
 */
public record SignalUse(String signal, String name, InputAction input, RunStateAction output) {}
