package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.testing.TestResult;

class CellDeviceTest {
  private static final String[] CLOSE = {
    "def close():",
    "  socket_open(\"127.0.0.1\", 63352)",
    "  socket_set_var(\"POS\", 255)",
    "  socket_read_byte_list(3)",
    "  sleep(1)",
    "  global found = socket_get_var(\"OBJ\")",
    "end"
  };

  @Test
  void aTestPutsAGripperAndAPartIntoTheCell() {
    TestResult result =
        Suite.of(
                "def test_grip():",
                "  add_device(\"two-finger\")",
                "  put_part(\"two-finger\", 0.03)",
                "  start(\"close.script\")",
                "  wait_for_end()",
                "  assert_equal(program_variable(\"found\"), 2)",
                "  assert_near(finger_opening(\"two-finger\"), 0.03, 0.0001)",
                "  assert_near(finger_force(\"two-finger\"), 235, 0.1)",
                "end")
            .with("cell/close.script", CLOSE)
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void aDeviceThatIsNotKnownIsRefusedWithThoseThereAre() {
    TestResult result =
        Suite.of("def test_grip():", "  add_device(\"three-finger\")", "end").only();

    String why = result.failure().orElseThrow().toString();
    assertTrue(why.contains("must be one of two-finger, two-finger-tool, rg, 2fg"), why);
  }

  @Test
  void aPartNeedsAGripper() {
    TestResult result = Suite.of("def test_grip():", "  put_part(\"left\", 0.03)", "end").only();

    String why = result.failure().orElseThrow().toString();
    assertTrue(why.contains("gripper is \\\"left\\\"") || why.contains("gripper is \"left\""), why);
  }

  @Test
  void aTestHasTheSceneThatItIsMarkedWith() {
    TestResult result =
        Suite.of(
                "# @scene ../cells/one.json",
                "def test_cell():",
                "  assert_near(object_pose(\"ball\")[2], 0.5)",
                "  assert_true(object_there(\"ball\"))",
                "  assert_false(object_there(\"ball #2\"))",
                "  assert_near(finger_opening(\"rg\"), 0.11)",
                "end")
            .with(
                "cells/one.json",
                "{\"devices\": [{\"type\": \"rg\"}], \"objects\": [{\"type\": \"sphere\",",
                " \"name\": \"ball\", \"centre\": [1, 0, 0.5], \"radius\": 0.1, \"mass\": 1}]}")
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void anObjectThatIsNotThereIsNamed() {
    TestResult result = Suite.of("def test_cell():", "  object_pose(\"ball\")", "end").only();

    String why = result.failure().orElseThrow().message();
    assertTrue(why.contains("there is no object ball that can move in the cell"), why);
  }
}
