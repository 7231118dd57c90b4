package org.pendant.protocols.primary;

/**
 * Robot message: what the box tells primary clients as it happens. Texts are bytes, one {@code
 * char} a byte; times are controller time in µs.
 */
public sealed interface RobotMessage {

  /** The first message on a new connection: which software this is. */
  record Version() implements RobotMessage {}

  /** The second message on a new connection; its meaning is not published. */
  record Second() implements RobotMessage {}

  /** A line that a program writes with {@code textmsg}. */
  record Text(long timeUs, String text) implements RobotMessage {}

  /**
   * The safety mode has changed.
   *
   * @param mode number of the new mode, from 1
   */
  record Safety(long timeUs, int mode) implements RobotMessage {}

  /**
   * A coded message such as C153A2.
   *
   * @param code behind the C
   * @param argument after the A
   * @param text our words for it
   */
  record ErrorCode(long timeUs, int code, int argument, Level level, String text)
      implements RobotMessage {}

  /**
   * Something about a program.
   *
   * @param title what, in the controller's words
   * @param text name of the program, or what is wrong
   */
  record Key(long timeUs, String title, String text) implements RobotMessage {}

  /**
   * A question to the operator, or a popup, which wants no value.
   *
   * @param id popups and questions are counted together, from 1
   */
  record Request(long timeUs, long id, Wanted wanted, String text) implements RobotMessage {}

  /**
   * An error of a program, before it runs or while.
   *
   * @param timeUs {@link #BEFORE} where the program has not run
   * @param line 1-based
   * @param column 1-based
   */
  record RuntimeFault(long timeUs, int line, int column, String text) implements RobotMessage {}

  /**
   * The program has come to another node of PolyScope's tree.
   *
   * @param number of the node
   * @param thread name of the function that the thread began with
   */
  record Labels(long timeUs, int number, String text, String thread) implements RobotMessage {}

  /** Time of what has no time. */
  long BEFORE = -1;

  /** How bad a coded message is. */
  enum Level {
    INFO(1),
    WARNING(2),
    VIOLATION(3);

    private final int number;

    Level(int number) {
      this.number = number;
    }

    /** Its number in packages. */
    public int number() {
      return number;
    }
  }

  /** What a request asks for. */
  enum Wanted {
    BOOLEAN(0),
    INTEGER(1),
    FLOAT(2),
    STRING(3),
    NOTHING(8);

    private final int number;

    Wanted(int number) {
      this.number = number;
    }

    /** Its number in packages. */
    public int number() {
      return number;
    }
  }
}
