package org.pendant.sweep.table;

import java.util.List;
import org.pendant.models.arm.Joints;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.run.JointLoads;
import org.pendant.sweep.run.LineTime;
import org.pendant.sweep.run.OutputChange;
import org.pendant.sweep.run.RunOutcome;
import org.pendant.sweep.run.SweepResult;

/** Results for tests, made without a run. */
public final class SomeResults {
  private SomeResults() {}

  /** A result with numbers that follow from that of the variant. */
  public static SweepResult of(SweepVariant variant) {
    double some = 1 / (variant.number() + 3.0);
    JointLoads loads = new JointLoads(Joints.ZERO, Joints.ZERO, Joints.ZERO);
    return new SweepResult(
        variant,
        variant.number() % 5 == 4 ? RunOutcome.STOPPED : RunOutcome.FINISHED,
        variant.number() % 5 == 4 ? "C154A0 \"stop\",\nsaid so" : "",
        12,
        some,
        loads,
        loads,
        loads,
        some,
        some,
        some,
        Double.POSITIVE_INFINITY,
        some,
        0,
        0,
        100 * some,
        List.of(some, -some, 0.5),
        List.of(new LineTime(12, 3)),
        List.of(new OutputChange("digital_out[0]", true, 0.5)),
        List.of("é"),
        variant.number());
  }
}
