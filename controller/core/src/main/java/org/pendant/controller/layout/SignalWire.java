package org.pendant.controller.layout;

import org.pendant.controller.wire.CellSignal;

/**
 * Wire between controllers of a cell: an input has the level of another signal, a frame later.
 *
 * @param from any digital signal
 * @param to an input, to which no other wire leads
 */
public record SignalWire(CellSignal from, CellSignal to) {}
