package org.pendant.recording.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringReader;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;

class SampleTableTest {
  private static final StateQuantity POSITION = StateQuantities.of("actual_q");
  private static final StateQuantity SPEED = StateQuantities.of("actual_qd");
  private static final StateQuantity CURRENT = StateQuantities.of("current");
  private static final String Q =
      "actual_q_0 actual_q_1 actual_q_2 actual_q_3 actual_q_4 actual_q_5";
  private static final List<String> ALPHABETIC =
      List.of(
          "elbow_joint",
          "shoulder_lift_joint",
          "shoulder_pan_joint",
          "wrist_1_joint",
          "wrist_2_joint",
          "wrist_3_joint");

  private static SampleTable.Read read(String text) throws Exception {
    return SampleTable.read("a.csv", new StringReader(text), OptionalDouble.empty());
  }

  private static String refusal(String text) {
    return assertThrows(MalformedTable.class, () -> read(text)).getMessage();
  }

  private static void assertRows(SampleTable.Read read) {
    Samples samples = read.samples();
    assertEquals(2, samples.rows());
    assertEquals(0, samples.timeS(0));
    assertEquals(0.5, samples.timeS(1), 1e-6);
    for (int i = 0; i < 6; i++) {
      assertEquals(1 + i, samples.value(POSITION, i, 0));
      assertEquals(10 + i, samples.value(POSITION, i, 1));
    }
  }

  @Test
  void readsWhatTheClientOfRtdeWrites() throws Exception {
    assertRows(
        read(
            "timestamp "
                + Q
                + " safety_mode robot_status_bits\r\n"
                + "7.25 1.0 2.0 3.0 4.0 5.0 6.0 1 True\r\n"
                + "7.75 10.0 11.0 12.0 13.0 14.0 15.0 1 3\r\n"));
  }

  @ParameterizedTest
  @CsvSource(
      value = {"','", "';'", "'\t'", "' '"},
      delimiter = '|')
  void readsAnySeparator(String separator) throws Exception {
    String table = "time_s " + Q + "\n0 1 2 3 4 5 6\n0.5 10 11 12 13 14 15\n";
    assertRows(read(table.replace(" ", separator)));
  }

  @Test
  void readsPendantsOwnNames() throws Exception {
    StateQuantity tcp = StateQuantities.of("target_tcp");
    String poses = "target_tcp_0,target_tcp_1,target_tcp_2,target_tcp_3,target_tcp_4,target_tcp_5";
    Samples samples =
        read("time_s,"
                + Q.replace(' ', ',')
                + ","
                + poses
                + ",line\n"
                + "1,1,2,3,4,5,6,.1,.2,.3,.4,.5,.6,3\n"
                + "1.002,1,2,3,4,5,6,.1,.2,.3,.4,.5,.6,3\n")
            .samples();
    assertEquals(List.of(POSITION, tcp), samples.quantities());
    assertEquals(0.3, samples.value(tcp, 2, 1));
  }

  private static String joined(String separator, String stem) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 6; i++) {
      text.append(i == 0 ? "" : separator).append(stem).append(i);
    }
    return text.toString();
  }

  /** A row in the alphabetic order of ROS, with joint i at {@code first + i}. */
  private static String alphabetic(int first) {
    return (first + 2)
        + ","
        + (first + 1)
        + ","
        + first
        + ","
        + (first + 3)
        + ","
        + (first + 4)
        + ","
        + (first + 5);
  }

  @Test
  void readsRos2TopicEchoWithoutHeadings() throws Exception {
    String names = String.join(",", ALPHABETIC);
    SampleTable.Read read =
        read(
            "100,250000000,,"
                + names
                + ","
                + alphabetic(1)
                + ","
                + alphabetic(20)
                + ","
                + alphabetic(40)
                + "\n100,750000000,base,"
                + names
                + ","
                + alphabetic(10)
                + ","
                + alphabetic(20)
                + ","
                + alphabetic(40)
                + "\n");
    assertRows(read);
    assertEquals(20, read.samples().value(SPEED, 0, 0));
    assertEquals(45, read.samples().value(CURRENT, 5, 0));
  }

  @Test
  void readsRostopicEchoWithStampsInNanoseconds() throws Exception {
    String heading =
        "%time,field.header.seq,field.header.stamp,"
            + joined(",", "field.name")
            + ","
            + joined(",", "field.position");
    String names = String.join(",", ALPHABETIC);
    assertRows(
        read(
            heading
                + "\n1600000000100000000,1,1600000000000000000,"
                + names
                + ","
                + alphabetic(1)
                + "\n1600000000900000000,2,1600000000500000000,"
                + names
                + ","
                + alphabetic(10)
                + "\n"));
  }

  @Test
  void readsListsInOneCell() throws Exception {
    String names = "\"['" + String.join("', '", ALPHABETIC) + "']\"";
    SampleTable.Read read =
        read(
            "time,.header.stamp.secs,.header.stamp.nsecs,.name,.position,.velocity\n2020/1/1,5,0,"
                + names
                + ",\"("
                + alphabetic(1)
                + ")\",[]\n2020/1/1,5,500000000,"
                + names
                + ",\"array('d', ["
                + alphabetic(10)
                + "])\",[]\n");
    assertRows(read);
    assertEquals(List.of(POSITION), read.samples().quantities());
  }

  @Test
  void readsColumnsThatAreNamedByTheJoint() throws Exception {
    StringBuilder heading = new StringBuilder("__time");
    for (String joint : ALPHABETIC) {
      heading.append(",/joint_states/ur3_").append(joint).append("/position");
    }
    assertRows(read(heading + "\n3.5," + alphabetic(1) + "\n4.0," + alphabetic(10) + "\n"));
  }

  @Test
  void leavesOutMessagesOfOtherJoints() throws Exception {
    String names = "['" + String.join("', '", ALPHABETIC) + "']";
    SampleTable.Read read =
        read(
            "Time,name,position\n0.1,['finger'],[0.7]\n1,"
                + names
                + ",["
                + alphabetic(1)
                + "]\n1.5,"
                + names
                + ",["
                + alphabetic(10)
                + "]\n");
    assertEquals(2, read.samples().rows());
    assertTrue(read.notes().toString().contains("1 rows repeat a time or lack a joint"));
  }

  @Test
  void namesTheLineAndColumnOfWhatIsNoNumber() {
    String message = refusal("time_s " + Q + "\n0 1 2 3 4 5 6\n1 1 2 x3 4 5 6\n");
    assertEquals("a.csv:3:7: there is 'x3', expected a number", message);
  }

  @Test
  void refusesWhatCannotBeCompared() {
    assertTrue(refusal("").contains("a.csv:1:1: the file is empty"));
    assertTrue(refusal("time_s,a\n1,2\n").contains("neither actual_q_0"));
    assertTrue(refusal("time_s " + Q + "\n").contains("no rows"));
    assertTrue(refusal(Q + "\n1 2 3 4 5 6\n").contains("--frequency"));
    assertTrue(refusal("time_s " + Q + "\n0 1 2 3 4 5\n0 1\n").contains("must have 7"));
    assertTrue(refusal("time_s " + Q + "\n1 1 2 3 4 5 6\n0 1 2 3 4 5 6\n").contains("before"));
    assertTrue(refusal("time_s " + Q + "\n0 1 2 3 4 5 NaN\n").contains("'NaN'"));
    assertTrue(refusal("1,2,3\n").contains("without headings"));
    assertTrue(refusal("Time,position\n1,[1]\n").contains("names of the joints"));
    assertTrue(refusal("time_s " + Q + "\n0 1 2 3 4 5 \0\n").contains("zero byte"));
  }

  @Test
  void leavesOutALineThatIsCutOff() throws Exception {
    SampleTable.Read read = read("time_s " + Q + "\n0 1 2 3 4 5 6\n0.5 10 11 12 13 14 15\n1 1 2");
    assertRows(read);
    assertEquals(List.of("the last line is cut off and left out"), read.notes());
  }

  @Test
  void aGivenFrequencyStandsForTimes() throws IOException, MalformedTable {
    String table = Q + "\n1 2 3 4 5 6\n10 11 12 13 14 15\n";
    assertRows(SampleTable.read("a.csv", new StringReader(table), OptionalDouble.of(0.5)));
  }

  @Test
  void aQuantityThatLacksAColumnIsLeftOut() throws Exception {
    SampleTable.Read read =
        read("time_s " + Q + " target_qd_0\n0 1 2 3 4 5 6 0\n0.5 10 11 12 13 14 15 0\n");
    assertRows(read);
    assertEquals(List.of("target_qd has 1 of 6 columns and is left out"), read.notes());
  }
}
