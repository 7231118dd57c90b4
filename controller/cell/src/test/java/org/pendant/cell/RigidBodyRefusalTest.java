package org.pendant.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

class RigidBodyRefusalTest {
  @Test
  void numbersOutsideTheirRangeAreRefused() {
    refused("radius is NaN m, must be 0.001 to 10 m", () -> new BodyShape.Sphere(Double.NaN));
    refused("friction is -0.1, must be 0 to 2", () -> new BodySurface(-0.1, 0, 1000));
    refused(
        "mass is 0 kg, must be 0.001 to 1000 kg",
        () ->
            BodyDescription.free(
                "ball", new BodyShape.Sphere(0.1), Bodies.at(0, 0, 0), 0, BodySurface.DEFAULT));
    refused(
        "pose[2] is Infinity m, must be -10 to 10 m",
        () -> Bodies.cube("box", 0.1, Bodies.at(0, 0, Double.POSITIVE_INFINITY), 0.3));
  }

  @Test
  void bodiesThatOverlapAreRefused() {
    refused(
        "bodies: box and other overlap by 20 mm",
        () ->
            Bodies.upright(
                List.of(
                    Bodies.cube("box", 0.1, Bodies.at(0, 0, 1), 0.3),
                    Bodies.cube("other", 0.1, Bodies.at(0.08, 0, 1), 0.3))));
  }

  @Test
  void twoBodiesOfOneNameAreRefused() {
    refused(
        "bodies: box is there twice",
        () ->
            Bodies.upright(
                List.of(
                    Bodies.cube("box", 0.1, Bodies.at(0, 0, 1), 0.3),
                    Bodies.cube("box", 0.1, Bodies.at(1, 0, 1), 0.3))));
  }

  @Test
  void tooManyBodiesAreRefused() {
    List<BodyDescription> bodies = new ArrayList<>();
    for (int i = 0; i <= RigidBodyWorld.MAX_BODIES; i++) {
      bodies.add(Bodies.cube("box " + i, 0.01, Bodies.at(0.02 * i, 0, 1), 0.3));
    }
    refused("bodies: are 221, may be at most 220", () -> Bodies.upright(bodies));
  }

  private static void refused(String message, Executable made) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, made).getMessage());
  }
}
