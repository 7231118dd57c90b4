package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.device.Zone;
import org.pendant.controller.device.camera.PartCamera;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.world.GripperSetup;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

final class DeviceSightTest {
  private static final DeviceSetup GRIPPER = new DeviceSetup.TwoFinger("left", false, true, 0);
  private static final DeviceSetup DOOR =
      new DeviceSetup.Door(
          "guard",
          new CellSignal("", "digital_out", 0),
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          2,
          Optional.empty());
  private static final DeviceSetup GATE =
      new DeviceSetup.Sensor(
          "gate",
          new CellSignal("", "digital_in", 0),
          new Zone.Beam(new Zone.Place(0.4, -0.3, 0.2), new Zone.Place(0.4, 0.3, 0.2), 0.01),
          false);

  private static DeviceState state(String name, double strokeM, double openingM, boolean on) {
    return new DeviceState(name, "device", strokeM, openingM, 0, on, 0, 0, 0);
  }

  @Test
  void devicesAreSeenAsTheyAre() {
    DeviceSight sight =
        DeviceSight.of(
            List.of(GATE, GRIPPER, DOOR),
            List.of(
                state("gate", 0, 0, true),
                state("left", 0.085, 0.03, true),
                state("guard", 1, 0.4, false)),
            false);
    DeviceSight.Gripper gripper = sight.grippers().getFirst();
    assertEquals(OptionalDouble.of(0.03), gripper.openingM());
    assertTrue(gripper.holds());
    assertTrue(sight.sensors().getFirst().sees());
    assertEquals("guard: 40 % open", sight.doors().getFirst().words());
  }

  @Test
  void whatIsNotKnownOfThePastIsNotClaimed() {
    DeviceSight sight = DeviceSight.of(List.of(GATE, GRIPPER, DOOR), List.of(), false);
    assertEquals(OptionalDouble.empty(), sight.grippers().getFirst().openingM());
    assertFalse(sight.sensors().getFirst().sees());
    assertEquals("guard", sight.doors().getFirst().words());
  }

  @Test
  void whatIsProposedIsSeenAsItBegins() {
    DeviceSight sight = DeviceSight.of(List.of(GRIPPER, DOOR), List.of(), true);
    assertEquals(OptionalDouble.of(0.085), sight.grippers().getFirst().openingM());
    assertEquals("guard: open", sight.doors().getFirst().words());
  }

  @Test
  void fingersAreAsFarApartAsTheyAreOpenAroundTheToolCentrePoint() {
    SceneModel model =
        Models.of("ur5e")
            .withTool(new Pose(0, 0, 0.16, 0, 0, 0))
            .withDevices(
                DeviceSight.of(List.of(GRIPPER), List.of(state("left", 0.085, 0.06, true)), false));
    List<Matrix4f> places =
        GripperPlaces.of(
                model, new LinkPlaces(model.kinematics(), model.arm().dh(), model.positionRad()))
            .getFirst();
    Vector3f one = places.get(2).getTranslation(new Vector3f());
    Vector3f other = places.get(3).getTranslation(new Vector3f());
    assertEquals(0.06, one.distance(other), 1e-6);
    Pose tcp = model.tcpInBase();
    Vector3f middle = one.add(other).mul(0.5f);
    assertEquals(tcp.x(), middle.x, 1e-6);
    assertEquals(tcp.y(), middle.y, 1e-6);
    assertEquals(tcp.z(), middle.z, 1e-6);
  }

  @Test
  void allGrippersAreSeenEachWhereItIs() {
    Pose aside = new Pose(0.08, 0, 0.1, 0, 1, 0);
    DeviceSetup cup =
        new DeviceSetup.Vacuum(
            "cup",
            new CellSignal("", "digital_out", 0),
            Optional.empty(),
            0.1,
            false,
            Optional.of(
                new GripperSetup(
                    Optional.of(aside), GripperSetup.Grip.Cup.DEFAULT, GripperSetup.RUBBER)));
    SceneModel model =
        Models.of("ur5e").withDevices(DeviceSight.of(List.of(GRIPPER, cup), List.of(), true));
    LinkPlaces links = new LinkPlaces(model.kinematics(), model.arm().dh(), model.positionRad());
    List<List<Matrix4f>> places = GripperPlaces.of(model, links);
    assertEquals(2, places.size());
    Matrix4f expected = new Matrix4f(links.of(Link.WRIST_3)).mul(LinkPlaces.matrix(aside));
    assertTrue(expected.equals(places.getLast().get(1), 1e-6f));
  }

  @Test
  void aSensorThatSeesHasAnotherColour() {
    List<DeviceSetup> gate = List.of(GATE);
    DeviceSight clear = DeviceSight.of(gate, List.of(state("gate", 0, 0, false)), false);
    DeviceSight broken = DeviceSight.of(gate, List.of(state("gate", 0, 0, true)), false);
    assertNotEquals(
        DeviceOutlines.of(clear, SceneTheme.LIGHT).number(0, 4),
        DeviceOutlines.of(broken, SceneTheme.LIGHT).number(0, 4));
    assertEquals(-0.3, DeviceOutlines.of(clear, SceneTheme.DARK).number(0, 1), 1e-6);
  }

  @Test
  void aLightBarrierIsHeldAtBothEndsAndInItsMiddle() {
    List<DeviceHandles.Handle> handles =
        DeviceHandles.of(DeviceSight.of(List.of(GATE), List.of(), true));
    assertEquals(
        List.of("", "from", "to"), handles.stream().map(DeviceHandles.Handle::key).toList());
    assertEquals(0, handles.getFirst().placeM().y(), 1e-12);
    assertEquals(0.3, handles.getLast().placeM().y(), 1e-12);
  }

  @Test
  void chevronsGoAlongWithABelt() {
    DeviceSetup belt = new DeviceSetup.Belt("belt", "conveyor", 0.1, 1, Optional.empty(), -1, 0);
    List<DeviceState> runs = List.of(state("belt", 0, 0, true));
    BeltTravel travel = new BeltTravel();
    assertEquals(Map.of(), travel.at(1, List.of(belt), runs));
    DeviceSight sight = DeviceSight.of(List.of(belt), runs, false);
    DeviceSight later = sight.withTravel(travel.at(1.2, List.of(belt), runs));
    assertEquals(0.02, later.belts().getFirst().travelM(), 1e-12);
    List<SceneObject> conveyor =
        List.of(
            new SceneObject.Box("conveyor", Pose.ZERO, new Vector3(1, 0.2, 0.1), Material.DEFAULT));
    double before = BeltOutlines.of(sight.belts(), conveyor, SceneTheme.LIGHT).number(0, 0);
    double after = BeltOutlines.of(later.belts(), conveyor, SceneTheme.LIGHT).number(0, 0);
    assertEquals(0.02, after - before, 1e-6);
    assertEquals(
        0.02,
        travel.at(5, List.of(belt), List.of(state("belt", 0, 0, false))).get("belt"),
        1e-12,
        "it stands still");
  }

  @Test
  void aLampThatHasAPlaceIsSeenLit() {
    CellSignal signal = new CellSignal("", "digital_out", 1);
    Pose at = new Pose(0.5, 0, 0.5, 0, 0, 0);
    List<DeviceSetup> lamps =
        List.of(
            new DeviceSetup.Lamp("busy", signal, Optional.of(at)),
            new DeviceSetup.Lamp("nowhere", signal, Optional.empty()));
    DeviceSight sight = DeviceSight.of(lamps, List.of(state("busy", 0, 0, true)), false);
    assertEquals(List.of(new DeviceSight.Lamp("busy", at, true)), sight.lamps());
    assertFalse(DeviceSight.of(lamps, List.of(), true).lamps().getFirst().lit());
  }

  @Test
  void placesOfTheCellAreInTheFrameOfTheBaseFromWhichTheyAreSeen() {
    DeviceSight sight =
        DeviceSight.of(List.of(GATE), List.of(), true)
            .seenFrom(Poses.inverse(new Pose(1, 0, 0, 0, 0, Math.PI)));
    Vector3 name = DeviceOutlines.namePlace(sight, sight.sensors().getFirst().zone());
    assertEquals(0.6, name.x(), 1e-12);
    assertEquals(0.3, name.y(), 1e-12);
    assertEquals(0.6, DeviceHandles.of(sight).getFirst().placeM().x(), 1e-12);
  }

  @Test
  void anotherArmStandsAtItsBaseAndBelongsToThePicture() {
    SceneModel model = Models.of("ur5e");
    OtherArm other =
        new OtherArm(
            "right",
            model.arm(),
            model.kinematics(),
            model.positionRad(),
            Pose.ZERO,
            new Pose(3, 0, 0, 0, 0, 0),
            List.of(),
            List.of(),
            List.of());
    LinkPlaces own = new LinkPlaces(model.kinematics(), model.arm().dh(), model.positionRad());
    Vector3f wrist = own.of(Link.WRIST_3).getTranslation(new Vector3f());
    Vector3f otherWrist = other.places().of(Link.WRIST_3).getTranslation(new Vector3f());
    assertEquals(3, otherWrist.x - wrist.x, 1e-5);
    assertTrue(
        SceneBounds.of(model.withOthers(List.of(other))).balls().stream()
            .anyMatch(each -> each.centreM().x() > 2.5));
  }

  @Test
  void aCameraThatIsChosenShowsWhatItSeesFromWhereItIs() {
    DeviceSetup camera =
        new DeviceSetup.Camera(
            "eye",
            new Zone.Area(new Zone.Place(0.3, -0.3, 0), new Zone.Place(0.7, 0.3, 0.2)),
            List.of(),
            Optional.of(new Pose(0.5, 0, 1, Math.PI, 0, 0)),
            false,
            new DeviceSetup.Camera.Ports(50100, 50101),
            new PartCamera.Errors(0, 0, 0));
    DeviceSight seen = DeviceSight.of(List.of(camera), List.of(), false);
    assertEquals(List.of(), seen.choosing("other", List.of(camera)).views());
    DeviceSight chosen = seen.choosing("eye", List.of(camera));
    assertEquals(new Vector3(0.5, 0, 1), chosen.views().getFirst().eyeInCell());
    assertTrue(
        DeviceOutlines.of(chosen, SceneTheme.LIGHT).size()
            > DeviceOutlines.of(seen, SceneTheme.LIGHT).size());
  }
}
