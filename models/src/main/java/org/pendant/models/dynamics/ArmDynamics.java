package org.pendant.models.dynamics;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.dense.row.mult.VectorVectorMult_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.JointAngles;

/**
 * Arm dynamics: torques that a motion needs, and the motion that torques give (manual 16.12,
 * 16.21).
 *
 * <p>{@code M(q) qdd + C(q, qd) qd + g(q) = torque}. The payload is welded to the last link.
 * Friction is not part of it; the inertia of the rotors counts where a method says so. Gravity is
 * the acceleration that a resting arm feels, along the axes of the base, as programs set it (manual
 * 16.48); an acceleration of the base adds to it (manual 16.44).
 *
 * <p>Arrays have six numbers, base joint first, in rad, rad/s, rad/s² and Nm. Methods write into
 * their last parameter and allocate nothing. An object keeps scratch space between calls: it must
 * not be used by two threads at once.
 */
public final class ArmDynamics {
  /** What a resting arm on the floor feels upwards, m/s². */
  public static final double STANDARD_GRAVITY_M_PER_S2 = 9.82;

  private static final int N = Joints.COUNT;
  private static final double[] ZERO = new double[N];

  private final JointAngles angles;
  private final NewtonEuler newtonEuler;
  private final CompositeBodies composite;
  private final RigidBody[] bodies = new RigidBody[N];
  private final RigidBody lastLink;
  private final double[] rotor = new double[N];
  private final double[] gravity = {0, 0, STANDARD_GRAVITY_M_PER_S2};
  private final double[] baseAcceleration = new double[3];

  private final DMatrixRMaj factor = new DMatrixRMaj(N, N);
  private final DMatrixRMaj side = new DMatrixRMaj(N, 1);
  private final DMatrixRMaj solution = new DMatrixRMaj(N, 1);
  private final LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.symmPosDef(N);

  /** Dynamics of an arm without payload, upright and at rest. */
  public ArmDynamics(ArmDescription arm) {
    this(arm, new JointAngles());
  }

  /**
   * As {@link #ArmDynamics(ArmDescription)}.
   *
   * @param angles of the posture that is computed, shared with others that compute the same one
   */
  public ArmDynamics(ArmDescription arm, JointAngles angles) {
    for (int i = 0; i < N; i++) {
      bodies[i] = RigidBody.of(arm.links().get(i));
      rotor[i] = arm.actuators().get(i).rotorInertiaKgM2();
    }
    lastLink = bodies[N - 1];
    this.angles = angles;
    newtonEuler = new NewtonEuler(arm.dh(), bodies, angles);
    composite = new CompositeBodies(arm.dh(), bodies, angles);
    mount();
  }

  /**
   * Cosines and sines of the posture that was computed last; who computes something of a posture
   * right before this does can leave them here.
   */
  public JointAngles angles() {
    return angles;
  }

  /** Welds a payload to the flange, in place of the one before. */
  public void setPayload(Payload payload) {
    bodies[N - 1] =
        payload.equals(Payload.NONE) ? lastLink : lastLink.weldedTo(RigidBody.of(payload));
    composite.changed(N - 1);
  }

  /** Sets what a resting arm feels along the axes of the base, m/s². */
  public void setGravity(double x, double y, double z) {
    set(gravity, x, y, z);
  }

  /** Sets the acceleration of the base along its axes, m/s². */
  public void setBaseAcceleration(double x, double y, double z) {
    set(baseAcceleration, x, y, z);
  }

  private void set(double[] vector, double x, double y, double z) {
    vector[0] = x;
    vector[1] = y;
    vector[2] = z;
    mount();
  }

  private void mount() {
    newtonEuler.setBase(
        gravity[0] + baseAcceleration[0],
        gravity[1] + baseAcceleration[1],
        gravity[2] + baseAcceleration[2]);
  }

  /** Torques that a motion needs, without rotors and friction. */
  public void inverse(double[] q, double[] qd, double[] qdd, double[] torque) {
    newtonEuler.torques(q, qd, qdd, true, torque);
  }

  /**
   * Takes the motion of {@link #flangeMotion} alone, in half the time of {@link #inverse}.
   *
   * @param q six joint positions, rad
   * @param qd six joint speeds, rad/s
   * @param qdd six joint accelerations, rad/s²
   */
  public void moveFlange(double[] q, double[] qd, double[] qdd) {
    newtonEuler.moveFlange(q, qd, qdd);
  }

  /**
   * How the flange moves in the latest call of {@link #inverse} or {@link #moveFlange}; the same
   * object always.
   */
  public FlangeMotion flangeMotion() {
    return newtonEuler.flange;
  }

  /** Torques that hold the arm. */
  public void gravity(double[] q, double[] torque) {
    newtonEuler.torques(q, ZERO, ZERO, true, torque);
  }

  /** Coriolis and centrifugal torques {@code C(q, qd) qd} (manual 16.12). */
  public void coriolis(double[] q, double[] qd, double[] torque) {
    newtonEuler.torques(q, qd, ZERO, false, torque);
  }

  /**
   * The mass matrix (manual 16.21).
   *
   * @param withRotors whether the rotors before the gears count
   * @param mass six by six, overwritten, kg m²
   */
  public void mass(double[] q, boolean withRotors, DMatrixRMaj mass) {
    composite.mass(q, mass.data);
    if (withRotors) {
      for (int i = 0; i < N; i++) {
        mass.data[N * i + i] += rotor[i];
      }
    }
  }

  /**
   * Accelerations that torques give.
   *
   * @param torque torques of drives, friction and outside forces, Nm
   * @param withRotors whether the rotors have to be accelerated, too
   * @param qdd overwritten; it may be the array of the torques
   * @throws IllegalStateException if the mass matrix is not positive definite
   */
  public void forward(double[] q, double[] qd, double[] torque, boolean withRotors, double[] qdd) {
    newtonEuler.torques(q, qd, ZERO, true, side.data);
    mass(q, withRotors, factor);
    for (int i = 0; i < N; i++) {
      side.data[i] = torque[i] - side.data[i];
    }
    if (!solver.setA(factor)) {
      throw new IllegalStateException("the mass matrix is not positive definite");
    }
    solver.solve(side, solution);
    System.arraycopy(solution.data, 0, qdd, 0, N);
  }

  /** Kinetic energy of links and payload, J. */
  public double kineticEnergyJ(double[] q, double[] qd) {
    composite.mass(q, factor.data);
    System.arraycopy(qd, 0, solution.data, 0, N);
    return 0.5 * VectorVectorMult_DDRM.innerProdA(solution, factor, solution);
  }

  /** Work against gravity and the base's acceleration that lifted the arm from height 0, J. */
  public double potentialEnergyJ(double[] q) {
    return composite.potentialEnergyJ(
        q,
        gravity[0] + baseAcceleration[0],
        gravity[1] + baseAcceleration[1],
        gravity[2] + baseAcceleration[2]);
  }

  /**
   * Linear momentum of links and payload along the axes of the base.
   *
   * @param momentum three numbers, kg m/s, overwritten
   */
  public void linearMomentum(double[] q, double[] qd, double[] momentum) {
    angles.at(q);
    composite.linearMomentum(angles, qd, momentum);
  }

  /**
   * The same for a posture whose cosines and sines are known already.
   *
   * @param angles of the six joints
   * @param qd six joint speeds, rad/s
   * @param momentum three numbers, kg m/s, overwritten
   */
  public void linearMomentum(JointAngles angles, double[] qd, double[] momentum) {
    composite.linearMomentum(angles, qd, momentum);
  }

  /**
   * The same for joint positions whose frames are known already.
   *
   * @param frames of the links in the base frame, as {@link
   *     org.pendant.models.kinematics.ForwardKinematics#frames} gives them for the nominal arm
   * @param qd six joint speeds, rad/s
   * @param momentum three numbers, kg m/s, overwritten
   */
  public void linearMomentum(double[][] frames, double[] qd, double[] momentum) {
    composite.linearMomentum(frames, qd, momentum);
  }
}
