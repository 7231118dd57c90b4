package org.pendant.testing.source;

import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Sent assertions: the functions of tests that a robot lacks, in its own language, for tests that
 * are sent there as a whole. They take the line that they stand at first, and tell what has come of
 * the test by lines of the log.
 */
public final class SentAssertions {
  /** Ends a test with success; stands behind the mark of its line. */
  public static final String DONE = "done";

  /** Ends a test that is red. */
  public static final String FAILED = "failed";

  /** Ends a test that makes no sense. */
  public static final String SKIPPED = "skipped";

  /** Says which error a test wants. */
  public static final String EXPECTS = "expects";

  /** Stands before their names at the robot. */
  static final String PREFIX = "pendant_";

  /** What all of them use; the log gets {@code MARK WHAT LINE TEXT}. */
  private static final String COMMON =
      """
      def pendant_tell(line, what, text):
        textmsg(str_cat(str_cat("MARK ", what), str_cat(str_cat(" ", to_str(line)), str_cat(" ", text))))
      end
      def pendant_shown(value):
        local text = to_str(value)
        if str_len(text) > 200:
          text = str_cat(str_sub(text, 0, 200), "...")
        end
        return text
      end
      def pendant_end():
        pendant_tell(0, "done", "")
        halt
      end
      def pendant_red(line, message, function, what):
        local first = function
        if str_len(message) > 0:
          first = message
        end
        pendant_tell(line, "failed", str_cat(str_cat(first, ": "), what))
        halt
      end
      def pendant_is(actual, expected):
        return str_cat(str_cat("is ", pendant_shown(actual)), str_cat(", must be ", pendant_shown(expected)))
      end
      def pendant_close(actual, expected, tolerance):
        local apart = actual - expected
        return apart <= tolerance and apart >= 0 - tolerance
      end
      """;

  private static final Map<String, String> ALL =
      Map.of(
          "assert_true",
          """
          def pendant_assert_true(line, condition, message=""):
            if not condition:
              pendant_red(line, message, "assert_true", "condition is False, must be True")
            end
          end
          """,
          "assert_false",
          """
          def pendant_assert_false(line, condition, message=""):
            if condition:
              pendant_red(line, message, "assert_false", "condition is True, must be False")
            end
          end
          """,
          "assert_equal",
          """
          def pendant_assert_equal(line, actual, expected, message=""):
            if not (actual == expected):
              pendant_red(line, message, "assert_equal", pendant_is(actual, expected))
            end
          end
          """,
          "assert_not_equal",
          """
          def pendant_assert_not_equal(line, actual, unexpected, message=""):
            if actual == unexpected:
              pendant_red(line, message, "assert_not_equal", str_cat(str_cat("is ", pendant_shown(actual)), ", must be anything else"))
            end
          end
          """,
          "assert_near",
          """
          def pendant_assert_near(line, actual, expected, tolerance=0.000001, message=""):
            local near = True
            if str_at(to_str(actual), 0) == "[":
              near = length(actual) == length(expected)
              local i = 0
              while near and i < length(actual):
                near = pendant_close(actual[i], expected[i], tolerance)
                i = i + 1
              end
            else:
              near = pendant_close(actual, expected, tolerance)
            end
            if not near:
              pendant_red(line, message, "assert_near", str_cat(pendant_is(actual, expected), str_cat(" +- ", to_str(tolerance))))
            end
          end
          """,
          "assert_joints_near",
          """
          def pendant_assert_joints_near(line, actual, expected, deg=0.1, message=""):
            local i = 0
            while i < 6:
              if not pendant_close(r2d(actual[i]), r2d(expected[i]), deg):
                pendant_red(line, message, "assert_joints_near", str_cat(str_cat("joint ", to_str(i)), str_cat(" ", pendant_is(actual[i], expected[i]))))
              end
              i = i + 1
            end
          end
          """,
          "assert_pose_near",
          """
          def pendant_assert_pose_near(line, actual, expected, mm=0.1, deg=0.1, message=""):
            local turn = pose_trans(pose_inv(actual), expected)
            local angle = r2d(norm([turn[3], turn[4], turn[5]]))
            if not (point_dist(actual, expected) * 1000 <= mm and angle <= deg):
              pendant_red(line, message, "assert_pose_near", pendant_is(actual, expected))
            end
          end
          """,
          "fail",
          """
          def pendant_fail(line, message=""):
            pendant_red(line, message, "fail", "the test says so")
          end
          """,
          "skip",
          """
          def pendant_skip(line, reason):
            pendant_tell(line, "skipped", reason)
            halt
          end
          """,
          "expect_failure",
          """
          def pendant_expect_failure(line, message):
            pendant_tell(line, "expects", message)
          end
          """);

  private SentAssertions() {}

  /** The functions of tests that are there. */
  public static Set<String> names() {
    return ALL.keySet();
  }

  /**
   * Those that a test calls.
   *
   * @param mark stands before what they tell
   */
  static String text(List<String> called, String mark) {
    StringBuilder text = new StringBuilder(COMMON.replace("MARK", mark));
    called.stream().distinct().sorted().forEach(each -> text.append(ALL.getOrDefault(each, "")));
    return text.toString();
  }
}
