package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.world.Material;
import org.pendant.models.time.FrameTime;

/**
 * Force mode against curves recorded of a UR10e: a tool of 6.86 kg goes down through free space
 * with a force and a gain, without damping, at no more than 0.25 m/s, and meets metal.
 */
@Tag("slow")
final class ForceModeRecordedTest {
  /**
   * The recordings do not say how stiff the metal and the sensor below it are; with this an impact
   * has about the recorded force.
   */
  private static final Material METAL = new Material(120_000, 0.2, 0.3);

  private static final int CONTACT_FRAMES = 1800;

  /** The recorded peaks are means of 20 ms. */
  private static final int MEAN_FRAMES = 10;

  private record Pressed(PressingArm arm, double timeS, double speedMPerS, List<Double> forcesN) {
    static Pressed with(double forceN, double gain, double pathM) {
      PressingArm arm = PressingArm.overTable("ur10e", pathM, METAL);
      start(arm, forceN, gain);
      int frames = 0;
      double speed = 0;
      while (arm.pressN() < 1) {
        speed = speed(arm);
        arm.frames(1);
        frames++;
      }
      List<Double> forces = new ArrayList<>();
      arm.frames(CONTACT_FRAMES, () -> forces.add(arm.pressN()));
      return new Pressed(arm, frames * FrameTime.FRAME_S, speed, forces);
    }

    static void start(PressingArm arm, double forceN, double gain) {
      arm.start(
          """
          set_payload(6.86, [0, 0, 0.08])
          force_mode_set_damping(0)
          force_mode_set_gain_scaling(%s)
          thread press():
            while True:
              force_mode(get_actual_tcp_pose(), [0, 0, 1, 0, 0, 0], [0, 0, %s, 0, 0, 0], 2,\
           [0.1, 0.1, 0.25, 0.1, 0.1, 0.1])
              sync()
            end
          end
          run press()
          sleep(10)
          """
              .formatted(gain, forceN));
    }

    static double speed(PressingArm arm) {
      return -arm.running.state().geometry().actual().speed().z();
    }

    /** The largest mean of 20 ms, N. */
    double peakN() {
      double highest = 0;
      for (int i = 0; i + MEAN_FRAMES <= forcesN.size(); i++) {
        highest = Math.max(highest, meanN(i, i + MEAN_FRAMES));
      }
      return highest;
    }

    double meanN(int from, int to) {
      return forcesN.subList(from, to).stream().mapToDouble(n -> n).average().orElseThrow();
    }

    double steadyN() {
      return meanN(CONTACT_FRAMES - 500, CONTACT_FRAMES);
    }

    /** When the force stays within 10 % of what is wanted. */
    double settledS(double wantedN) {
      Predicate<Double> beside = n -> Math.abs(n - wantedN) > 0.1 * wantedN;
      int last = CONTACT_FRAMES - 1;
      while (last >= 0 && !beside.test(forcesN.get(last))) {
        last--;
      }
      return (last + 1) * FrameTime.FRAME_S;
    }
  }

  @ParameterizedTest
  @CsvSource({
    "15, 0.5, 0.136, 1.464, 0.170, 200",
    "15, 1, 0.069, 0.787, 0.170, 249",
    "35, 0.5, 0.136, 0.952, 0.243, 277",
    "35, 1, 0.069, 0.517, 0.236, 501",
    "55, 0.5, 0.135, 0.792, 0.235, 267",
    "55, 1, 0.069, 0.418, 0.224, 444",
    "100, 0.5, 0.304, 1.408, 0.234, 298"
  })
  void theToolMeetsTheMetalWhenAndAsHardAsRecorded(
      double forceN, double gain, double pathM, double timeS, double speedMPerS, double peakN) {
    Pressed pressed = Pressed.with(forceN, gain, pathM);
    assertEquals(timeS, pressed.timeS(), 0.1 * timeS);
    assertEquals(speedMPerS, pressed.speedMPerS(), 0.15 * speedMPerS);
    double peak = pressed.peakN();
    assertTrue(peak > peakN / 2 && peak < 2 * peakN, () -> peak + " N");
    assertEquals(forceN, pressed.steadyN(), 0.05 * forceN);
    assertEquals(SafetyMode.NORMAL, pressed.arm().running.state().safety().safetyMode());
  }

  @ParameterizedTest
  @CsvSource({"35, 1, 0.069, 0.69", "55, 1, 0.069, 0.78", "100, 0.5, 0.304, 1.74"})
  void theForceSettlesAboutAsSoonAsRecorded(
      double forceN, double gain, double pathM, double settledS) {
    double settled = Pressed.with(forceN, gain, pathM).settledS(forceN);
    assertEquals(settledS, settled, 0.5 * settledS);
  }

  @Test
  void inFreeSpaceItGainsSpeedByWhatItIsPushedWith() {
    PressingArm free = new PressingArm(ControllerOptions.headless().withRobot("ur10e"));
    Pressed.start(free, 35, 0.5);
    free.frames(50);
    double before = Pressed.speed(free);
    free.frames(100);
    double perS2 = (Pressed.speed(free) - before) / (100 * FrameTime.FRAME_S);
    assertEquals(0.018 * 35 * 0.5, perS2, 0.01);
  }
}
