package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.pendant.command.service.StandardView;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.Models;
import org.pendant.desktop.scene.SceneBounds;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.TcpTrace;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.scene.WaypointMarkers.Mark;
import org.pendant.desktop.scene.WaypointMarkers.Stop;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.models.pose.Pose;

final class MarkFinderTest {
  private static final IntFunction<String> LINES = line -> "Line " + line;
  private static final int WIDTH = 800;
  private static final int HEIGHT = 600;
  private static final Pose FEEDER = new Pose(0.4, -0.3, 0.1, 0, 0, 0);
  private static final Pose TRAY = new Pose(0.4, 0.3, 0.1, 0, 0, 0);

  private static final Pose CORNER = new Pose(-0.4, 0.3, 0.1, 0, 0, 0);

  private static final Pose ELBOW = new Pose(-0.3, 0.2, 0.4, 0, 0, 0);

  private final SceneModel model =
      Models.of("ur5e")
          .withWaymarks(
              new WaypointMarkers(
                  List.of(
                      new Mark("Feeder", FEEDER, false, 3),
                      new Mark("Tray", TRAY, true, 4),
                      new Mark("Corner", CORNER, false, 7)),
                  List.of(
                      List.of(
                          new Stop(0, 3, "MoveJ at 60 deg/s", false),
                          new Stop(1, 4, "MoveL at 250 mm/s", true)))));
  private final Camera camera =
      Camera.of(StandardView.ISO, SceneBounds.of(model), (double) WIDTH / HEIGHT);

  private MarkFinder finder(LabelPlaces.Placed... labels) {
    return new MarkFinder(
        new PictureRequest(model, camera, WIDTH, HEIGHT),
        WIDTH,
        HEIGHT,
        List.of(labels),
        PoseForm.STANDARD,
        LINES);
  }

  private Point2D pixel(Pose pose) {
    return camera.pixel(new Vector3(pose.x(), pose.y(), pose.z()), WIDTH, HEIGHT).orElseThrow();
  }

  private static Point near(Point2D at) {
    return new Point((int) Math.round(at.getX()), (int) Math.round(at.getY()));
  }

  @Test
  void aPlaceIsFoundAtItsPointWithItsPoseAndTheNodeThatGoesThere() {
    MarkTarget found = finder().at(near(pixel(FEEDER))).orElseThrow();
    assertEquals(
        """
        Feeder
        400.00, -300.00, 100.00 mm
        RX 0.00\u00b0, RY 0.00\u00b0, RZ 0.00\u00b0
        MoveJ at 60 deg/s\
        """,
        found.words());
    assertEquals(3, found.node());
    assertTrue(found.from().isEmpty());
  }

  @Test
  void aPlaceThatNoNodeGoesToByItselfLeadsToTheNodeThatNamesIt() {
    assertEquals(7, finder().at(near(pixel(CORNER))).orElseThrow().node());
  }

  @Test
  void aWayIsFoundBetweenItsPlacesWithHowItIsGone() {
    Pose middle = new Pose(0.4, 0, 0.1, 0, 0, 0);
    MarkTarget found = finder().at(near(pixel(middle))).orElseThrow();
    assertEquals("Feeder \u2192 Tray\nMoveL at 250 mm/s", found.words());
    assertEquals(4, found.node());
    assertEquals(Optional.of(pixel(FEEDER)), found.from());
    assertEquals(List.of(found), finder().chosenWays());
  }

  @Test
  void aPlaceIsFoundAtItsNameToo() {
    Rectangle2D box = new Rectangle2D.Double(5, 5, 60, 20);
    LabelPlaces.Placed name =
        new LabelPlaces.Placed(new LabelPlaces.Label("Tray", pixel(TRAY), 1, true), box, true);
    assertEquals(4, finder(name).at(new Point(30, 15)).orElseThrow().node());
    assertEquals(Optional.empty(), finder().at(new Point(30, 15)));
  }

  private MarkFinder finder(TcpTrace trace, PoseForm form) {
    return finder(trace, form, LINES);
  }

  private MarkFinder finder(TcpTrace trace, PoseForm form, IntFunction<String> places) {
    return new MarkFinder(
        new PictureRequest(model.withTrace(trace), camera, WIDTH, HEIGHT),
        WIDTH,
        HEIGHT,
        List.of(),
        form,
        places);
  }

  private static Pose above(Pose place) {
    return new Pose(place.x(), place.y(), place.z() + 0.1, 0, 0, 0);
  }

  @Test
  void aPointOfTheWayOfTheToolTellsItsLinePlaceSpeedAndHowLongTheLineTook() {
    MarkFinder finder = finder(Models.trace(TRAY, 44), PoseForm.STANDARD);
    MarkTarget found = finder.at(near(pixel(above(TRAY)))).orElseThrow();
    assertEquals(44, found.line());
    assertEquals(
        "Line 44, 2 s\n400.00, 300.00, 200.00 mm\n100 mm/s\nA click explains the speed",
        found.words());
  }

  @Test
  void aPointOfTheWayOfTheToolTellsTheNodeThatItsLineIsGeneratedFrom() {
    MarkFinder finder =
        finder(Models.trace(TRAY, 44), PoseForm.STANDARD, line -> "Node 15 from line " + line);
    MarkTarget found = finder.at(near(pixel(above(TRAY)))).orElseThrow();
    assertTrue(found.words().startsWith("Node 15 from line 44, 2 s\n"), found.words());
  }

  @Test
  void theWayOfTheElbowLeadsToItsLineToo() {
    TcpTrace both = Models.trace(TRAY, 44).withElbow(Models.trace(ELBOW, 45));
    MarkTarget found = finder(both, PoseForm.STANDARD).at(near(pixel(above(ELBOW)))).orElseThrow();
    assertEquals(45, found.line());
    assertEquals(1, found.timeS());
    assertTrue(found.words().startsWith("Elbow\nLine 45, 2 s\n"), found.words());
    MarkTarget tool = finder(both, PoseForm.STANDARD).at(near(pixel(above(TRAY)))).orElseThrow();
    assertEquals(44, tool.line());
  }

  @Test
  void aWayIsFoundBetweenItsPointsToo() {
    Pose between = new Pose(TRAY.x(), TRAY.y(), TRAY.z() + 0.13, 0, 0, 0);
    MarkFinder finder = finder(Models.trace(TRAY, 44), PoseForm.STANDARD);
    assertEquals(44, finder.at(near(pixel(between))).orElseThrow().line());
  }

  @Test
  void placesAndSpeedsAreInTheUnitsThatPeopleHaveChosen() {
    PoseForm metres = new PoseForm(DisplayUnit.METRE, DisplayUnit.RADIAN, RotationForm.VECTOR);
    MarkTarget found =
        finder(Models.trace(TRAY, 44), metres).at(near(pixel(above(TRAY)))).orElseThrow();
    assertEquals(
        "Line 44, 2 s\n0.40000, 0.30000, 0.20000 m\n0.1 m/s\nA click explains the speed",
        found.words());
  }
}
