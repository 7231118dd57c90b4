package org.pendant.controller.box;

import java.util.Optional;
import org.pendant.controller.device.EncoderLines;
import org.pendant.controller.device.ToolPlaces;
import org.pendant.controller.io.Signals;
import org.pendant.controller.wire.SignalLines;
import org.pendant.controller.world.ArmNeighbours;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.LinkCollisions;

/**
 * Cell station: the place of one controller among those that share a cell.
 *
 * @param signals its own
 * @param lines the signals of all controllers, its own without a name in front
 * @param contacts what its arm may touch, in the base frame of that arm
 * @param neighbours the other arms, as its own sees them; empty where it has none
 * @param encounters what its links get into of other arms; empty where they pass through
 * @param tools of all arms in the cell
 * @param encoders of all controllers in the cell
 * @param armless whether it has no arm: the one that it reckons with is nowhere
 */
public record CellStation(
    Signals signals,
    SignalLines lines,
    ContactWorld contacts,
    Optional<ArmNeighbours> neighbours,
    Optional<LinkCollisions> encounters,
    ToolPlaces tools,
    EncoderLines encoders,
    boolean armless) {}
