package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.util.Arrays;
import java.util.Optional;

/**
 * Inertia of a payload about its centre of gravity, along the axes of the flange, kg m² (manual
 * 16.52).
 *
 * @param ixx not negative
 * @param iyy not negative
 * @param izz not negative
 * @param ixy the tensor's element as it stands
 * @param ixz the tensor's element as it stands
 * @param iyz the tensor's element as it stands
 */
public record Inertia(double ixx, double iyy, double izz, double ixy, double ixz, double iyz) {
  /** Largest element either way, kg m² (manual 16.52). */
  public static final double MAX_KG_M2 = 133;

  /** That of a point. */
  public static final Inertia NONE = new Inertia(0, 0, 0, 0, 0, 0);

  /** What rounding may do, relative to the largest element. */
  private static final double ROUNDING = 1e-9;

  /** Six elements in the order of the manual: [Ixx, Iyy, Izz, Ixy, Ixz, Iyz]. */
  public static Inertia of(double... elements) {
    if (elements.length != 6) {
      throw new IllegalArgumentException(
          "inertia has " + elements.length + " elements, must have 6");
    }
    return new Inertia(
        elements[0], elements[1], elements[2], elements[3], elements[4], elements[5]);
  }

  private double[] elements() {
    return new double[] {ixx, iyy, izz, ixy, ixz, iyz};
  }

  /** Why no payload can be declared to have it, such as {@code Ixx must not be negative}. */
  public Optional<String> problem() {
    if (Arrays.stream(elements()).anyMatch(each -> !(Math.abs(each) <= MAX_KG_M2))) {
      return Optional.of(text("eachKgM2", (int) MAX_KG_M2, (int) MAX_KG_M2));
    }
    if (ixx < 0 || iyy < 0 || izz < 0) {
      return Optional.of(text("firstThree"));
    }
    return turnsWithEnergy() ? Optional.empty() : Optional.of(text("noBody"));
  }

  /**
   * Whether a turn about any axis has an energy of 0 or more: no principal minor is negative. With
   * other inertias the equations of motion have no solution.
   */
  private boolean turnsWithEnergy() {
    double largest = Arrays.stream(elements()).map(Math::abs).max().orElse(0);
    double room = ROUNDING * largest * largest;
    double determinant =
        ixx * (iyy * izz - iyz * iyz)
            - ixy * (ixy * izz - iyz * ixz)
            + ixz * (ixy * iyz - iyy * ixz);
    return ixx * iyy - ixy * ixy >= -room
        && ixx * izz - ixz * ixz >= -room
        && iyy * izz - iyz * iyz >= -room
        && determinant >= -room * largest;
  }
}
