package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

class PeerTest {
  private static final String[] VISION = {
    "def vision():",
    "  global ok = socket_open(\"192.168.1.20\", 5000)",
    "  socket_send_line(\"trigger\")",
    "  global answer = socket_read_line(\"socket_0\", 2)",
    "  socket_close()",
    "end"
  };

  @Test
  void theTestPlaysTheCameraThatAProgramAsks() {
    TestResult result =
        Suite.of(
                "thread camera():",
                "  peer_expect(5000, \"trigger\")",
                "  sleep(0.3)",
                "  peer_send_line(5000, \"12;34\")",
                "end",
                "def test_vision():",
                "  listen(5000)",
                "  run camera()",
                "  start(\"vision.script\")",
                "  eventually(peer_connected(5000))",
                "  began = robot_time()",
                "  wait_for_end()",
                "  assert_equal(program_variable(\"answer\"), \"12;34\")",
                "  assert_near(robot_time() - began, 0.3, 0.02)",
                "end")
            .with("cell/vision.script", VISION)
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void aPeerThatHangsLetsTheProgramMeetItsTimeout() {
    TestResult result =
        Suite.of(
                "def test_vision():",
                "  listen(5000)",
                "  start(\"vision.script\")",
                "  wait_for_end()",
                "  assert_equal(program_variable(\"answer\"), \"\")",
                "  assert_true(robot_time() > 2)",
                "end")
            .with("cell/vision.script", VISION)
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void aProgramIsRefusedWhereTheTestPlaysNobody() {
    TestResult result =
        Suite.of(
                "def test_vision():",
                "  start(\"vision.script\")",
                "  eventually(not program_running())",
                "  assert_equal(program_variable(\"ok\"), False)",
                "  assert_log(\"the test plays no peer at port 5000\")",
                "end")
            .with(
                "cell/vision.script",
                "def vision():",
                "  global ok = socket_open(\"192.168.1.20\", 5000)",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void aPeerMayRefuseDelayAndHangUp() {
    TestResult result =
        Suite.of(
                "def test_faults():",
                "  listen(7)",
                "  peer_refuse(7)",
                "  assert_false(socket_open(\"host\", 7))",
                "  peer_refuse(7, False)",
                "  assert_true(socket_open(\"host\", 7))",
                "  peer_delay(7, 0.1)",
                "  peer_send_line(7, \"late\")",
                "  began = robot_time()",
                "  assert_equal(socket_read_line(\"socket_0\", 1), \"late\")",
                "  assert_near(robot_time() - began, 0.1, 0.01)",
                "  peer_hang_up(7)",
                "  assert_equal(socket_read_line(\"socket_0\", 1), \"\")",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void whatDoesNotComeFailsTheTestAndShowsWhatCame() {
    TestResult result =
        Suite.of(
                "def test_vision():",
                "  listen(5000)",
                "  start(\"vision.script\")",
                "  peer_expect(5000, \"shoot\", within=0.5)",
                "end")
            .with("cell/vision.script", VISION)
            .only();

    assertEquals(TestStatus.FAILED, result.status());
    assertEquals(
        "peer_expect: \"shoot\" did not come in time; what came ends with \"trigger\n\"",
        result.failure().orElseThrow().message());
  }

  @Test
  void theTestAnswersRemoteProcedures() {
    TestResult result =
        Suite.of(
                "def test_camera():",
                "  rpc_answer(\"get_part\", p[0.3, 0.1, 0, 0, 0, 0])",
                "  rpc_answer(\"count\", [2, 1])",
                "  start(\"camera.script\")",
                "  wait_for_end()",
                "  assert_pose_near(program_variable(\"part\"), p[0.3, 0.1, 0, 0, 0, 0])",
                "  assert_equal(program_variable(\"left\"), 1)",
                "  assert_equal(rpc_calls(\"count\"), 2)",
                "  assert_equal(rpc_argument(\"get_part\", 0), \"bracket\")",
                "end")
            .with(
                "cell/camera.script",
                "def camera():",
                "  cam = rpc_factory(\"xmlrpc\", \"http://127.0.0.1:4040/RPC2\")",
                "  global part = cam.get_part(\"bracket\")",
                "  global left = cam.count()",
                "  left = cam.count()",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
  }
}
