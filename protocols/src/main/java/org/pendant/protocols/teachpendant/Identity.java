package org.pendant.protocols.teachpendant;

/**
 * Identity: what stands on the type plate.
 *
 * @param model size of the robot without its series, such as {@code UR5}
 * @param serialNumber digits only
 */
public record Identity(String model, String serialNumber) {
  /** Our choice: the form of a real one, and every client takes it. */
  private static final String SERIAL_NUMBER = "20225500001";

  /**
   * Of the robot with an id of the library.
   *
   * @param robotId such as {@code ur5e}
   */
  public static Identity of(String robotId) {
    return new Identity("UR" + robotId.replaceAll("\\D", ""), SERIAL_NUMBER);
  }
}
