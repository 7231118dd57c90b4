package org.pendant.controller.state;

/**
 * Software version that the controller says it runs. The build number and its date are our choice:
 * clients compare the first three numbers only.
 *
 * @param build number of the build
 * @param buildDate as the box prints it: {@code Mon dd yyyy}
 */
public record SoftwareVersion(int major, int minor, int bugfix, int build, String buildDate) {
  /** What every controller of ours says. */
  public static final SoftwareVersion REPORTED =
      new SoftwareVersion(5, 24, 1, 1234567, "Oct 01 2025");

  /** All four numbers, such as {@code 5.24.1.1234567}. */
  public String text() {
    return major + "." + minor + "." + bugfix + "." + build;
  }
}
