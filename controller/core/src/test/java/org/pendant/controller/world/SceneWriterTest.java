package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

final class SceneWriterTest {

  private static Scene read(String text) throws JsonException {
    return SceneReader.read(
        "scene.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void nothingIsAnEmptyFile() {
    assertEquals("{}\n", SceneWriter.write(Scene.EMPTY));
  }

  @Test
  void anObjectIsALineWithWhatIsNotUsual() {
    Scene scene =
        new Scene(
            List.of(
                new SceneObject.Plane(
                    "table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT),
                new SceneObject.Sphere(
                    "a \"ball\"",
                    new Vector3(0.3, -0.0, 1e-4),
                    0.05,
                    new Material(5000, 0.6, 0.8))),
            Optional.empty(),
            List.of());
    assertEquals(
        """
        {
          "objects": [
            {"type": "plane", "name": "table", "point": [0, 0, 0], "normal": [0, 0, 1]},
            {"type": "sphere", "name": "a \\"ball\\"", "centre": [0.3, 0, 1.0E-4], "radius": 0.05, \
        "material": {"stiffness": 5000, "damping": 0.6, "friction": 0.8}}
          ]
        }
        """,
        SceneWriter.write(scene));
  }

  @Test
  void whatIsWrittenIsReadAsItWas() throws Exception {
    Random random = new Random(20);
    for (int i = 0; i < 200; i++) {
      Scene scene = any(random);
      assertEquals(scene, read(SceneWriter.write(scene)));
    }
  }

  private static Scene any(Random random) {
    List<SceneObject> objects = new ArrayList<>();
    for (int i = random.nextInt(5); i > 0; i--) {
      String name = "\u00e4 \u4e2d \\ " + i;
      Material material =
          random.nextBoolean()
              ? Material.DEFAULT
              : new Material(random.nextDouble(10, 2e5), random.nextDouble(2), 0.5);
      objects.add(
          switch (random.nextInt(3)) {
            case 0 -> new SceneObject.Plane(name, vector(random), new Vector3(0, -1, 0), material);
            case 1 -> new SceneObject.Box(name, pose(random), size(random), material);
            default ->
                new SceneObject.Sphere(
                    name, vector(random), random.nextDouble(0.001, 10), material);
          });
    }
    Optional<Payload> load =
        random.nextBoolean()
            ? Optional.empty()
            : Optional.of(new Payload(2.5, 0.01, -0.02, 0.1, 0.003, 0.003, 0.001, 0, 1e-5, 0));
    List<ToolPoint> tool =
        random.nextBoolean()
            ? List.of()
            : List.of(new ToolPoint(vector(random, 4), 0), new ToolPoint(vector(random, 4), 0.01));
    Wrench push = random.nextBoolean() ? Wrench.ZERO : new Wrench(0, 0, -20, 0, 0.5, 0);
    LinkContact links = random.nextBoolean() ? LinkContact.STOP : LinkContact.PASS;
    return new Scene(objects, load, tool, push, links);
  }

  private static Vector3 vector(Random random) {
    return vector(random, 10);
  }

  private static Vector3 vector(Random random, double most) {
    return new Vector3(
        random.nextDouble(-most, most),
        random.nextDouble(-most, most),
        random.nextDouble(-most, most));
  }

  private static Vector3 size(Random random) {
    return new Vector3(
        random.nextDouble(0.001, 10), random.nextDouble(0.001, 10), random.nextDouble(0.001, 10));
  }

  private static Pose pose(Random random) {
    Vector3 place = vector(random);
    return new Pose(
        place.x(), place.y(), place.z(), random.nextDouble(-3, 3), random.nextDouble(-3, 3), 0.1);
  }
}
