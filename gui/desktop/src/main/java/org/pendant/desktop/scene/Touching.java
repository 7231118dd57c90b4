package org.pendant.desktop.scene;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.controller.world.Contact;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/** Touch detection: tells which objects of a scene the tool touches. Belongs to one thread. */
public final class Touching {
  private static final double[] AT_REST = new double[6];

  private final ContactWorld world;
  private final double[] flange = new double[Transforms.SIZE];
  private final double[] wrench = new double[6];

  /** Looks at the objects and tool points of this scene. */
  public Touching(Scene scene) {
    world = new ContactWorld(scene);
  }

  /** The objects touched by an arm at rest at these joint positions, rad. */
  public List<Contact> contacts(
      ForwardKinematics kinematics, Joints positionRad, Pose tcpInFlange) {
    kinematics.flange(positionRad.toArray(), flange);
    double[] tcp = {tcpInFlange.x(), tcpInFlange.y(), tcpInFlange.z()};
    world.wrench(flange, tcp, AT_REST, wrench);
    return world.contacts();
  }

  /** Names of the objects touched by an arm at these joint positions, rad. */
  public Set<String> names(ForwardKinematics kinematics, Joints positionRad, Pose tcpInFlange) {
    return contacts(kinematics, positionRad, tcpInFlange).stream()
        .map(Contact::object)
        .collect(Collectors.toUnmodifiableSet());
  }
}
