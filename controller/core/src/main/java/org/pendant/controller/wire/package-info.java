/**
 * Signals of the cell by their names, those of the controller itself and those of other owners,
 * such as {@code plc.coil[1]}. Open {@link org.pendant.controller.wire.CellSignalNames} first;
 * {@link org.pendant.controller.wire.SignalLines} has them at work.
 */
package org.pendant.controller.wire;
