package org.pendant.sweep.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.sweep.plan.FrameAxis;

final class CellShiftTest {
  private static final double QUARTER = Math.PI / 2;

  private static Scene scene() throws JsonException {
    String text =
        """
        {"objects": [
          {"type": "plane", "name": "wall", "point": [1, 0, 0], "normal": [-1, 0, 0]},
          {"type": "box", "name": "part", "pose": [0.5, 0, 0.1, 0, 0, 0], "size": [0.1, 0.1, 0.1]},
          {"type": "sphere", "name": "ball", "centre": [0.5, 0.2, 0.1], "radius": 0.1}
        ]}
        """;
    return SceneReader.read(
        "s.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void objectIsDisplacedAlongTheBaseAndTurnedAboutItself() throws JsonException {
    Scene along = CellShift.withObject(scene(), "part", FrameAxis.Y, 0.2);
    SceneObject.Box part = (SceneObject.Box) along.objects().get(1);
    assertEquals(new Pose(0.5, 0.2, 0.1, 0, 0, 0), part.poseInBase());
    Scene turned = CellShift.withObject(scene(), "part", FrameAxis.RZ, QUARTER);
    SceneObject.Box same = (SceneObject.Box) turned.objects().get(1);
    assertEquals(0.5, same.poseInBase().x());
    assertEquals(QUARTER, same.poseInBase().rz(), 1e-12);
    assertEquals(scene().objects().getFirst(), turned.objects().getFirst());
  }

  @Test
  void sceneIsSeenFromABaseThatStandsElsewhere() throws JsonException {
    // turned to the left by a quarter, 0.5 m ahead
    Pose by = Poses.inverse(new Pose(0.5, 0, 0, 0, 0, QUARTER));
    Scene seen = CellShift.seenFrom(scene(), by);
    SceneObject.Plane wall = (SceneObject.Plane) seen.objects().getFirst();
    assertEquals(-0.5, wall.pointInBaseM().y(), 1e-12);
    assertEquals(1, wall.normalInBase().y(), 1e-12);
    SceneObject.Box part = (SceneObject.Box) seen.objects().get(1);
    assertEquals(0, part.poseInBase().x(), 1e-12);
    assertEquals(-QUARTER, part.poseInBase().rz(), 1e-12);
    SceneObject.Sphere ball = (SceneObject.Sphere) seen.objects().get(2);
    assertEquals(0.2, ball.centreInBaseM().x(), 1e-12);
  }

  @Test
  void featureOfThreePointsMovesAsOne() {
    Feature table =
        new Feature(
            "table",
            FeatureKind.PLANE,
            List.of(
                new Pose(0.4, 0.1, 0, 0, 0, 0),
                new Pose(0.6, 0.1, 0, 0, 0, 0),
                new Pose(0.4, 0.3, 0, 0, 0, 0)),
            false,
            true);
    Feature other =
        CellShift.withFeature(List.of(table), "table", FrameAxis.RZ, QUARTER).getFirst();
    Pose pose = FeaturePoses.pose(other).orElseThrow();
    assertEquals(0.4, pose.x(), 1e-12);
    assertEquals(0.1, pose.y(), 1e-12);
    assertEquals(QUARTER, pose.rz(), 1e-9);
  }
}
