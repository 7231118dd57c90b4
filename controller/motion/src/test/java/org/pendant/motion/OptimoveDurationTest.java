package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.motion.profile.ProfileLimits;

/**
 * Compares optimovej and optimovel with time-optimal durations from another program; {@code
 * src/test/reference/optimove_durations.py} makes the table.
 */
final class OptimoveDurationTest {
  private static final String TABLE = "optimove-durations.csv";
  private static final String HEAD = "kind,move,length,rate,rate2,rate3,duration_s";
  private static final int MOVES = 30;

  private final MoveChain chain = new MoveChain();

  /** A move and its row of the table, without the last column. */
  private record Planned(double durationS, String row) {}

  private Planned planned(String kind, int number, Move move) throws PlanningException {
    MotionPath path = move.route().from(MoveChain.READY);
    ProfileLimits limits = move.limits(path, 2);
    String row =
        String.join(
            ",",
            kind,
            Integer.toString(number),
            Double.toString(path.length()),
            Double.toString(limits.speed()),
            Double.toString(limits.acceleration()),
            Double.toString(limits.jerk()));
    return new Planned(MovePlanner.fromRest(move, MoveChain.READY, List.of()).durationS(), row);
  }

  private List<Planned> all() throws PlanningException {
    InverseKinematics inverse = new InverseKinematics(chain.arm);
    SplittableRandom random = new SplittableRandom(2);
    List<Planned> all = new ArrayList<>();
    for (int i = 0; i < MOVES; i++) {
      double[] goal = MoveChain.READY.toArray();
      for (int joint = 0; joint < Joints.COUNT; joint++) {
        goal[joint] += random.nextDouble(-1.5, 1.5);
      }
      double share = i < MOVES / 2 ? 1 : random.nextDouble(0.1, 1);
      all.add(planned("optimovej", i, chain.optimovej(Joints.of(goal), share, share, 0)));
    }
    for (int i = 0; i < MOVES; i++) {
      Pose goal =
          chain.shifted(
              random.nextDouble(-0.15, 0.1),
              random.nextDouble(-0.3, 0.3),
              random.nextDouble(-0.2, 0.1));
      assertTrue(inverse.solve(goal, MoveChain.TCP, MoveChain.READY).isPresent());
      double share = i < MOVES / 2 ? 1 : random.nextDouble(0.1, 1);
      all.add(planned("optimovel", i, chain.optimovel(goal, share, share, 0)));
    }
    return all;
  }

  private static List<String> table() throws IOException {
    try (InputStream table = OptimoveDurationTest.class.getResourceAsStream(TABLE)) {
      return new String(table.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
    }
  }

  @Test
  void takesAtMostFivePercentMoreThanTheTimeOptimalLaw() throws IOException, PlanningException {
    List<Planned> moves = all();
    List<String> rows = new ArrayList<>(List.of(HEAD));
    moves.forEach(each -> rows.add(each.row()));
    List<String> table = table();
    assertEquals(rows.size(), table.size(), () -> String.join("\n", rows));
    for (int i = 0; i < moves.size(); i++) {
      double[] was = numbers(table.get(i + 1));
      double[] is = numbers(moves.get(i).row());
      for (int column = 0; column < is.length; column++) {
        // the last digits may differ from one processor to another
        assertEquals(was[column], is[column], 1e-9 * is[column], () -> String.join("\n", rows));
      }
      double optimal = was[was.length - 1];
      double taken = moves.get(i).durationS();
      assertTrue(taken <= 1.05 * optimal, taken + " s, optimal are " + optimal);
      assertTrue(taken >= optimal - 1e-6, taken + " s, less than the optimal " + optimal);
    }
  }

  private static double[] numbers(String row) {
    return Arrays.stream(row.split(",")).skip(2).mapToDouble(Double::parseDouble).toArray();
  }
}
