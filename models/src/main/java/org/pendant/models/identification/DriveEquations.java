package org.pendant.models.identification;

import java.util.Optional;
import org.ejml.data.DMatrixRMaj;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.Confidence;
import org.pendant.models.arm.FrictionCurve;

/** Drive equations: the systems of {@link DriveFit} for the samples of one drive. */
final class DriveEquations {
  /** Where speed v1 of the curved part is searched for, rad/s. */
  private static final double SLOWEST_CURVE = 0.05;

  private static final double FASTEST_CURVE = 2;
  private static final int CURVES = 30;

  /** Unknowns of friction: coulomb, curved, viscous; behind them comes 1 / K. */
  private static final int OF_FRICTION = 3;

  private static final int DRY = 1;
  private static final int MOMENT = 1 << OF_FRICTION;

  private final Actuator model;
  private final double[] v;
  private final double[] momentNm;
  private final double[] currentA;

  /** The best numbers so far: coulomb, curved, viscous and 1 / K, which is 0 where it is known. */
  private record Best(
      double curveSpeed,
      double coulomb,
      double curved,
      double viscous,
      double inverseConstant,
      double rms) {}

  /**
   * @param speedRadPerS of the samples, rad/s
   * @param momentNm without friction, Nm
   * @param currentA of the drive, A
   */
  DriveEquations(Actuator model, double[] speedRadPerS, double[] momentNm, double[] currentA) {
    this.model = model;
    v = speedRadPerS.clone();
    this.momentNm = momentNm.clone();
    this.currentA = currentA.clone();
  }

  /** The best numbers, with the torque constant where the moments tell it. */
  DriveFit solve() {
    Optional<Best> withConstant =
        LeastSquares.determined(system(1, DRY | MOMENT)) ? best(true) : Optional.empty();
    return fit(withConstant.or(() -> best(false)).orElseThrow(), withConstant.isPresent());
  }

  /** Columns of those unknowns whose bit is set: coulomb, curved, viscous, moment. */
  private DMatrixRMaj system(double v1, int unknowns) {
    DMatrixRMaj system = new DMatrixRMaj(v.length, Integer.bitCount(unknowns));
    FrictionCurve dry = new FrictionCurve(1, 0, 1, 0, 0);
    for (int row = 0; row < v.length; row++) {
      double[] all = {dry.dryCurrentA(v[row], 0), Math.tanh(v[row] / v1), v[row], momentNm[row]};
      int column = 0;
      for (int i = 0; i < all.length; i++) {
        if ((unknowns >> i & 1) != 0) {
          system.set(row, column, all[i]);
          column++;
        }
      }
    }
    return system;
  }

  /** The current without what is known of it. */
  private DMatrixRMaj measured(boolean withConstant) {
    DMatrixRMaj measured = new DMatrixRMaj(v.length, 1);
    FrictionCurve ofLoad = new FrictionCurve(0, 0, 1, 0, model.friction().loadAPerNm());
    for (int row = 0; row < v.length; row++) {
      double ofMoment = withConstant ? 0 : momentNm[row] / model.torqueConstantNmPerA();
      measured.set(row, 0, currentA[row] - ofMoment - ofLoad.dryCurrentA(v[row], momentNm[row]));
    }
    return measured;
  }

  /** The best numbers of which none is negative; empty if there are none. */
  private Optional<Best> best(boolean withConstant) {
    DMatrixRMaj measured = measured(withConstant);
    int constant = withConstant ? MOMENT : 0;
    Best best = null;
    for (int i = 0; i <= CURVES; i++) {
      double v1 = SLOWEST_CURVE * Math.pow(FASTEST_CURVE / SLOWEST_CURVE, (double) i / CURVES);
      for (int friction = 0; friction < 1 << OF_FRICTION; friction++) {
        int chosen = friction | constant;
        DMatrixRMaj system = system(v1, chosen);
        if (chosen != 0 && !LeastSquares.determined(system)) {
          continue;
        }
        double[] found = chosen == 0 ? new double[0] : LeastSquares.solve(system, measured);
        double rms = LeastSquares.rms(system, found, measured);
        boolean possible = notNegative(found) && (!withConstant || found[found.length - 1] > 0);
        if (possible && (best == null || rms < best.rms)) {
          best = best(v1, found, chosen, rms);
        }
      }
    }
    return Optional.ofNullable(best);
  }

  private static boolean notNegative(double[] numbers) {
    for (double each : numbers) {
      if (!(each >= 0)) {
        return false;
      }
    }
    return true;
  }

  private static Best best(double v1, double[] found, int chosen, double rms) {
    double[] all = new double[OF_FRICTION + 1];
    int next = 0;
    for (int i = 0; i < all.length; i++) {
      if ((chosen >> i & 1) != 0) {
        all[i] = found[next];
        next++;
      }
    }
    return new Best(v1, all[0], all[1], all[2], all[OF_FRICTION], rms);
  }

  private DriveFit fit(Best best, boolean withConstant) {
    FrictionCurve friction =
        new FrictionCurve(
            best.coulomb,
            best.curved,
            best.curved > 0 ? best.curveSpeed : model.friction().curveSpeedRadPerS(),
            best.viscous,
            model.friction().loadAPerNm());
    double constant = withConstant ? 1 / best.inverseConstant : model.torqueConstantNmPerA();
    Actuator.Status status = model.status();
    return new DriveFit(
        new Actuator(
            model.rotorInertiaKgM2(),
            constant,
            friction,
            model.lagS(),
            new Actuator.Status(
                status.rotorInertia(),
                withConstant ? Confidence.MEASURED : status.torqueConstant(),
                Confidence.MEASURED)),
        withConstant,
        rms(model),
        best.rms);
  }

  /** What a drive leaves unexplained, A. */
  private double rms(Actuator drive) {
    double squares = 0;
    for (int row = 0; row < v.length; row++) {
      double expected =
          momentNm[row] / drive.torqueConstantNmPerA()
              + drive.friction().currentA(v[row], momentNm[row]);
      squares += (currentA[row] - expected) * (currentA[row] - expected);
    }
    return Math.sqrt(squares / v.length);
  }
}
