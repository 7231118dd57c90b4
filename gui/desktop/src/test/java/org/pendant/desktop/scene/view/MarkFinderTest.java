package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.command.service.StandardView;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.Models;
import org.pendant.desktop.scene.SceneBounds;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.scene.WaypointMarkers.Mark;
import org.pendant.desktop.scene.WaypointMarkers.Stop;
import org.pendant.models.pose.Pose;

final class MarkFinderTest {
  private static final int WIDTH = 800;
  private static final int HEIGHT = 600;
  private static final Pose FEEDER = new Pose(0.4, -0.3, 0.1, 0, 0, 0);
  private static final Pose TRAY = new Pose(0.4, 0.3, 0.1, 0, 0, 0);

  private final SceneModel model =
      Models.of("ur5e")
          .withWaymarks(
              new WaypointMarkers(
                  List.of(new Mark("Feeder", FEEDER, false), new Mark("Tray", TRAY, true)),
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
        pose -> 1000 * pose.x() + " mm");
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
    assertEquals("Feeder\n400.0 mm\nMoveJ at 60 deg/s", found.words());
    assertEquals(3, found.node());
    assertTrue(found.from().isEmpty());
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

  @Test
  void aPointOfTheWayOfTheToolTellsItsLineAndSpeed() {
    MarkFinder finder =
        new MarkFinder(
            new PictureRequest(model.withTrace(Models.trace(TRAY, 44)), camera, WIDTH, HEIGHT),
            WIDTH,
            HEIGHT,
            List.of(),
            pose -> "");
    Pose between = new Pose(TRAY.x(), TRAY.y(), TRAY.z() + 0.1, 0, 0, 0);
    MarkTarget found = finder.at(near(pixel(between))).orElseThrow();
    assertEquals(44, found.line());
    assertEquals("Line 44\n100 mm/s\nA click explains the speed", found.words());
  }
}
