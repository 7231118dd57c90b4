package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.world.ArmEncounters.Neighbour;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.collision.LinkCapsules;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;

/**
 * Cell world: the objects of a cell in which several arms stand, and the arms among them. Its frame
 * is that of the file; each arm has a {@link ContactWorld} in its own base frame.
 *
 * <p>Belongs to the thread that drives the cell.
 */
public final class CellWorld {
  /**
   * An arm in the cell.
   *
   * @param name what messages call it by
   * @param scene the objects as they are seen from its base, and what its tool is
   * @param startRad where its joints are at first
   * @param baseInCell where it stands
   * @param stops whether its links stop at those of others
   */
  public record Standing(
      String name,
      ArmDescription arm,
      Scene scene,
      Joints startRad,
      Pose baseInCell,
      boolean stops) {}

  private final List<Standing> arms;
  private final boolean solid;

  /** The objects that can move; null where there are none. */
  private final FreeBodies free;

  private final List<Neighbour> links = new ArrayList<>();
  private final List<ArmNeighbours> neighbours;

  /**
   * A cell with its arms.
   *
   * @param scene in the frame of the cell
   * @param arms at least one
   * @throws IllegalArgumentException if there are too many bodies, or if they overlap
   */
  public CellWorld(Scene scene, List<Standing> arms) {
    this.arms = List.copyOf(arms);
    solid = scene.links() == LinkContact.STOP;
    free =
        FreeBodies.any(scene.objects())
            ? new FreeBodies(scene.objects(), arms.stream().map(this::bodies).toList())
            : null;
    arms.forEach(arm -> links.add(ArmEncounters.neighbour(arm)));
    neighbours = ArmNeighbours.of(arms);
  }

  private ArmBodies.Setup bodies(Standing arm) {
    return new ArmBodies.Setup(
        arm.scene().tool(), solid ? LinkCapsules.of(arm.arm()) : List.of(), arm.baseInCell());
  }

  /** What an arm may touch, by its number. */
  public ContactWorld contacts(int arm) {
    Standing of = arms.get(arm);
    return new ContactWorld(
        of.scene(), free, free == null ? null : free.arm(arm), new ArmPlace(of.baseInCell()), true);
  }

  /** What a controller without an arm has there: nothing but what its sensors see. */
  public ContactWorld withoutArm() {
    return new ContactWorld(Scene.EMPTY, free, null, new ArmPlace(Pose.ZERO), true);
  }

  /** The other arms, as an arm sees them. */
  public ArmNeighbours neighbours(int arm) {
    return neighbours.get(arm);
  }

  /**
   * What links of an arm get into of the other arms; empty where links pass through all there is.
   */
  public Optional<LinkCollisions> encounters(int arm) {
    if (!solid || !arms.get(arm).stops()) {
      return Optional.empty();
    }
    List<Neighbour> others = new ArrayList<>(links);
    others.remove(arm);
    ArmEncounters encounters = new ArmEncounters(links.get(arm).links(), others);
    return encounters.pairs() > 0 ? Optional.of(new LinkCollisions(encounters)) : Optional.empty();
  }

  /** Lets the objects move for a frame; arms have said before where they are. */
  public void advance() {
    if (free != null) {
      free.advance(FrameTime.FRAME_S);
    }
  }
}
