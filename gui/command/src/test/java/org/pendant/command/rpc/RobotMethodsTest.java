package org.pendant.command.rpc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

final class RobotMethodsTest {
  private static final String CREATE = Lines.request(Lines.CREATE);
  private static final String START = Lines.request("program.start");
  private static final String END = Lines.request("advance", "'until':'ended'");
  private static final String COUNT =
      "def count():\n global n = 0\n while n < 5:\n  n = n + 1\n  sleep(0.1)\n end\nend";
  private static final String WAIT =
      "def wait():\n while not get_standard_digital_in(0):\n  sync()\n end\n"
          + " set_standard_digital_out(1, True)\n sleep(1)\nend";

  @Test
  void programRunsToItsEndAndItsVariablesAreRead() {
    List<String> answers =
        Lines.answers(CREATE, Lines.load(COUNT), START, END, Lines.request("variables"));
    assertTrue(answers.get(3).contains("\"reason\":\"ended\",\"frames\":251"), answers.get(3));
    assertTrue(answers.get(3).contains("\"ending\":{\"kind\":\"finished\"}"), answers.get(3));
    assertTrue(answers.get(4).endsWith("\"result\":{\"n\":5}}"), answers.get(4));
  }

  @Test
  void timePassesInAdvanceAlone() {
    List<String> answers =
        Lines.answers(
            CREATE,
            Lines.load(COUNT),
            START,
            Lines.request("speed", "'fraction':0.5"),
            Lines.request("inputs.set", "'values':{'digital_in[0]':true}"),
            Lines.request("state"));
    assertTrue(answers.getLast().contains("\"time_s\":0.0"), answers.getLast());
    assertTrue(answers.getLast().contains("\"state\":\"running\""), answers.getLast());
    assertTrue(answers.getLast().contains("\"digital_in\":[true,"), answers.getLast());
  }

  @Test
  void sameRequestsGetTheSameAnswers() {
    String[] requests = {
      CREATE,
      Lines.load("def a():\n movej([0,-1.5,1.5,0,0,random()])\nend"),
      START,
      Lines.request("advance", "'seconds':0.7"),
      Lines.request("recording", "'columns':['actual_q','tcp_speed']", "'every':7")
    };
    assertEquals(Lines.answers(requests), Lines.answers(requests));
  }

  @Test
  void advanceWaitsForAConditionOfSignalsAndVariables() {
    List<String> answers =
        Lines.answers(
            CREATE,
            Lines.load(WAIT),
            START,
            Lines.request("advance", "'until':{'digital_out[1]':true}", "'timeout':0.1"),
            Lines.request("inputs.set", "'values':{'digital_in[0]':true}"),
            Lines.request("advance", "'until':{'digital_out[1]':true}"),
            Lines.load(COUNT),
            Lines.request("program.stop"),
            START,
            Lines.request("advance", "'until':{'var:n':{'above':2.5,'below':9}}", "'state':false"));
    assertTrue(answers.get(3).contains("\"reason\":\"timeout\",\"frames\":50"), answers.get(3));
    assertTrue(answers.get(5).contains("\"reason\":\"condition\",\"frames\":1"), answers.get(5));
    assertTrue(
        answers.get(9).endsWith("{\"reason\":\"condition\",\"frames\":101}}"), answers.get(9));
  }

  @Test
  void analogInputsAreSetWhileAProgramRuns() {
    List<String> answers =
        Lines.answers(
            CREATE,
            Lines.load(WAIT),
            Lines.request("inputs.set", "'values':{'analog_in[0]':'5V'}"),
            START,
            Lines.request("inputs.set", "'values':{'analog_in[0]':2.5}"),
            Lines.request("read", "'names':['analog_in[0]','analog_in_domain']"));
    assertTrue(
        answers.getLast().endsWith("{\"analog_in[0]\":2.5,\"analog_in_domain\":[1,1]}}"),
        answers.toString());
  }

  @Test
  void mistakesComeWithTheirPlaces() {
    List<String> answers = Lines.answers(CREATE, Lines.load("def a():\n foo()\nend"), START);
    assertTrue(
        answers
            .get(1)
            .contains(
                "\"loaded\":false,\"diagnostics\":[{\"file\":\"program.script\",\"line\":2,"
                    + "\"column\":2,"),
        answers.get(1));
    assertTrue(answers.get(2).contains("\"code\":-32002"), answers.get(2));
  }

  @Test
  void failureOfAProgramSaysFileLineAndCode() {
    String ended = Lines.last(CREATE, Lines.load("def a():\n global x = 1 / 0\nend"), START, END);
    assertTrue(
        ended.contains(
            "\"code\":\"division-by-zero\",\"file\":\"program.script\",\"line\":2,\"column\":13"),
        ended);
  }

  @Test
  void popupsAndQuestionsEndAWaitForTheEndAndAreAnswered() {
    String program =
        "def a():\n popup(\\\"hold\\\", blocking=True)\n"
            + " global n = request_integer_from_primary_client(\\\"How many?\\\")\nend";
    List<String> answers =
        Lines.answers(
            CREATE,
            Lines.load(program),
            START,
            END,
            Lines.request("popup.close", "'number':1"),
            END,
            Lines.request("question.answer", "'number':2", "'answer':1.5"),
            Lines.request("question.answer", "'number':2", "'answer':4"),
            END,
            Lines.request("variables"));
    assertTrue(answers.get(3).contains("\"reason\":\"popup\""), answers.get(3));
    assertTrue(answers.get(5).contains("\"reason\":\"question\""), answers.get(5));
    assertTrue(answers.get(6).contains("\"code\":-32000"), answers.get(6));
    assertTrue(answers.get(8).contains("\"reason\":\"ended\""), answers.get(8));
    assertTrue(answers.get(9).endsWith("{\"n\":4}}"), answers.get(9));
  }

  @Test
  void devicesOfTheCellTellWhereTheyAreAndTakeParts() {
    String create = Lines.request(Lines.CREATE, "'device':'two-finger'");
    List<String> answers =
        Lines.answers(
            create,
            Lines.request("device.put_part", "'device':'two-finger'", "'width':0.03"),
            Lines.request("advance", "'frames':1"),
            Lines.request("devices"),
            Lines.request("device.put_part", "'device':'none'", "'width':0.03"));
    assertTrue(answers.get(3).contains("\"name\":\"two-finger\""), answers.get(3));
    assertTrue(answers.get(3).contains("\"part_m\":0.03"), answers.get(3));
    assertTrue(answers.get(4).contains("\"code\":-32000"), answers.get(4));
  }

  @Test
  void signalsOfTheCellAreSet() {
    List<String> answers =
        Lines.answers(
            Lines.request(Lines.CREATE, "'device':'two-finger'"),
            Lines.request("device.set_signal", "'signal':'plc.register[3]'", "'value':17"),
            Lines.request("advance", "'frames':1"),
            Lines.request("devices"),
            Lines.request("device.set_signal", "'signal':'plc.register[3]'", "'value':70000"));
    assertTrue(answers.get(3).contains("\"register[3]\":17"), answers.get(3));
    assertTrue(answers.get(4).contains("must be 0 to 65535"), answers.get(4));
  }

  @Test
  void refusalOfTheControllerHasItsCode() {
    String refused = Lines.last(CREATE, Lines.load(WAIT), START, START);
    assertTrue(
        refused.endsWith(
            "{\"code\":-32000,\"message\":\"program wait runs already\",\"data\":"
                + "{\"code\":\"program\"}}}"),
        refused);
  }

  @Test
  void emergencyStopHoldsTheArm() {
    String state =
        Lines.last(
            CREATE,
            Lines.request("safety.set", "'values':{'emergency_stop':true}"),
            Lines.request("advance", "'seconds':1"));
    assertTrue(state.contains("\"safety_mode\":\"robot_emergency_stop\""), state);
  }

  @Test
  void recordingHasARowForEachFrameThatIsWanted() {
    String[] program = {
      CREATE, Lines.load(COUNT), START, Lines.request("trace", "'variables':['n']")
    };
    List<String> answers =
        Lines.answers(
            program[0],
            program[1],
            program[3],
            program[2],
            END,
            Lines.request(
                "recording",
                "'from':0.1",
                "'to':0.34",
                "'columns':['var:n','timestamp']",
                "'every':50"));
    assertTrue(
        answers
            .getLast()
            .contains(
                "\"time_s\":[0.1,0.2,0.3],\"columns\":{\"var:n\":[1.0,2.0,3.0],"
                    + "\"timestamp\":[0.1,0.2,0.3]}"),
        answers.getLast());
  }

  @Test
  void longRecordingComesInPieces() {
    String piece =
        Lines.last(
            CREATE,
            Lines.request("advance", "'seconds':20", "'state':false"),
            Lines.request(
                "recording", "'columns':['actual_q','target_q','output_float_register']"));
    assertTrue(piece.contains("\"next_s\":16.392,\"time_s\":[0.0,0.002,"), piece.substring(0, 200));
  }

  @Test
  void waitThatTakesTooLongOnTheWallEnds() {
    String refused =
        Lines.last(
            CREATE, Lines.request("advance", "'seconds':80000", "'wall':0", "'state':false"));
    assertTrue(refused.contains("\"code\":-32004"), refused);
  }

  @Test
  void robotsAreKeptApartByTheirHandles() {
    List<String> answers =
        Lines.answers(
            CREATE,
            CREATE,
            Lines.request("state"),
            Lines.request("advance", "'handle':2", "'frames':3", "'state':false"),
            Lines.request("read", "'handle':1", "'names':['control_step']"),
            Lines.request("read", "'handle':2", "'names':['control_step']"),
            Lines.request("robot.close", "'handle':1"),
            Lines.request("robot.list"));
    assertTrue(answers.get(2).contains("handle is missing, there are 2 robots"), answers.get(2));
    assertTrue(answers.get(4).contains("{\"control_step\":0}"), answers.get(4));
    assertTrue(answers.get(5).contains("{\"control_step\":3}"), answers.get(5));
    assertTrue(answers.get(7).endsWith("\"result\":[2]}"), answers.get(7));
  }

  @Test
  void jointsBeginWhereTheyAreWanted() {
    String read =
        Lines.last(
            Lines.request(Lines.CREATE, "'start':[0.1,-1,1,0,0,0.5]"),
            Lines.request("read", "'names':['actual_q']"));
    assertTrue(read.endsWith("{\"actual_q\":[0.1,-1.0,1.0,0.0,0.0,0.5]}}"), read);
  }
}
