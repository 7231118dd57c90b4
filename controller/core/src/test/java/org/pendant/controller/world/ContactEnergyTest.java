package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** Touching things takes energy and never gives any. */
final class ContactEnergyTest {
  private static final double STEP_S = 0.0005;
  private static final double MASS_KG = 4;

  private static SceneObject table(Material material) {
    return new SceneObject.Plane("table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), material);
  }

  /** Speed with which a mass comes back up that met the table at {@code speedMPerS}. */
  private static double reboundMPerS(Material material, double speedMPerS) {
    ToolInWorld tool = ToolInWorld.among(table(material));
    double z = 0;
    double speed = -speedMPerS;
    for (int i = 0; i < 100_000 && !(z > 0 && speed > 0); i++) {
      speed += tool.at(0, 0, z).moving(0, 0, speed).feels().fz() / MASS_KG * STEP_S;
      z += speed * STEP_S;
    }
    return speed;
  }

  @Test
  void bounceIsNeverFasterThanTheImpact() {
    Random random = new Random(3);
    for (int i = 0; i < 200; i++) {
      Material material =
          new Material(1000 + 4e4 * random.nextDouble(), 0.1 + random.nextDouble(), 0.3);
      double speed = 0.1 + 0.9 * random.nextDouble();
      double rebound = reboundMPerS(material, speed);
      assertTrue(rebound > 0 && rebound < speed, material + " at " + speed + ": " + rebound);
    }
  }

  @Test
  void slowImpactLosesTheShareThatDampingSays() {
    double speed = 0.1;
    assertEquals(
        speed * (1 - 0.4 * speed), reboundMPerS(new Material(1e4, 0.4, 0), speed), 0.01 * speed);
  }

  @Test
  void stiffestMaterialStaysCalmInStepsOfTwoMilliseconds() {
    ToolInWorld tool = ToolInWorld.among(table(new Material(2e5, 2, 2)));
    double stepS = 0.002;
    double lightKg = 2;
    double[] place = {0, 0, 0.01};
    double[] speed = {0.2, 0, -0.1};
    for (int i = 0; i < 5000; i++) {
      Wrench wrench =
          tool.at(place[0], place[1], place[2]).moving(speed[0], speed[1], speed[2]).feels();
      speed[0] += wrench.fx() / lightKg * stepS;
      speed[2] += (wrench.fz() / lightKg - 9.82) * stepS;
      for (int k = 0; k < 3; k++) {
        place[k] += speed[k] * stepS;
      }
      assertTrue(Math.abs(speed[2]) < 0.5 && place[2] > -0.01, "step " + i + ": z " + place[2]);
    }
    assertEquals(-9.82 * lightKg / 2e5, place[2], 1e-5);
  }

  @Test
  void slidingMassComesToRest() {
    ToolInWorld tool = ToolInWorld.among(table(Material.DEFAULT));
    double x = 0;
    double speed = 1;
    double depth = 9.82 * MASS_KG / Material.DEFAULT.stiffnessNPerM();
    for (int i = 0; i < 4000; i++) {
      speed += tool.at(x, 0, -depth).moving(speed, 0, 0).feels().fx() / MASS_KG * STEP_S;
      x += speed * STEP_S;
    }
    assertEquals(0, speed, 1e-6);
    assertEquals(1 / (2 * 0.3 * 9.82), x, 0.01);
  }

  @Test
  void noWayThroughABoxAndBackGivesEnergy() {
    SceneObject box =
        new SceneObject.Box(
            "box",
            new Pose(0, 0, 0, 0.3, -0.2, 0.5),
            new Vector3(0.02, 0.03, 0.04),
            new Material(1e4, 0, 0));
    ToolInWorld tool = ToolInWorld.among(box);
    Random random = new Random(11);
    for (int way = 0; way < 100; way++) {
      Vector3 from = somewhere(random);
      Vector3 via = somewhere(random);
      Vector3 to = somewhere(random);
      double workJ = workJ(tool, from, via) + workJ(tool, via, to) + workJ(tool, to, from);
      // the springs involved hold up to 0.5 J; the rest is the sum's coarseness
      assertEquals(0, workJ, 5e-4, from + " " + via + " " + to);
    }
  }

  private static Vector3 somewhere(Random random) {
    return new Vector3(
        0.02 * random.nextGaussian(), 0.02 * random.nextGaussian(), 0.02 * random.nextGaussian());
  }

  /** What the contact gives to a point on a straight way, J. */
  private static double workJ(ToolInWorld tool, Vector3 from, Vector3 to) {
    int steps = 20_000;
    double dx = (to.x() - from.x()) / steps;
    double dy = (to.y() - from.y()) / steps;
    double dz = (to.z() - from.z()) / steps;
    double workJ = 0;
    for (int i = 0; i < steps; i++) {
      double middle = i + 0.5;
      Wrench wrench =
          tool.at(from.x() + middle * dx, from.y() + middle * dy, from.z() + middle * dz).feels();
      workJ += wrench.fx() * dx + wrench.fy() * dy + wrench.fz() * dz;
    }
    return workJ;
  }
}
