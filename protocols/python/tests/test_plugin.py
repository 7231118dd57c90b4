"""The plugin of pytest, in a run of its own."""

from __future__ import annotations


def test_fixtures_give_robots_and_failures_tell_of_them(pytester, plugin_arguments):
    pytester.makepyfile(
        """
        import pytest

        @pytest.mark.robot(model="ur3e", arm="ideal")
        def test_marked(robot):
            robot.advance(0.2)
            assert robot.state.time_s == 0.2

        @pytest.mark.robot("ur10e", arm="ideal")
        class TestOfClass:
            @pytest.mark.robot(seed=3)
            def test_fresh(self, robot):
                assert robot.state.time_s == 0

        def test_two(robot_factory):
            one, other = robot_factory("ur5e"), robot_factory("ur5e")
            one.advance(frames=1)
            assert (one.state.frame, other.state.frame) == (1, 0)

        def test_fails(robot):
            robot.load("a.script", 'def a():\\n textmsg("said")\\n set_standard_digital_out(2, True)\\nend')
            robot.start()
            robot.run_until_end()
            assert robot.state["digital_out[1]"]
        """
    )
    result = pytester.runpytest_inprocess("--strict-markers", *plugin_arguments)
    result.assert_outcomes(passed=3, failed=1)
    result.stdout.fnmatch_lines(
        [
            "*- Pendant robot -*",
            "time 0.002 s, frame 1",
            "program a: stopped, line 0",
            "ended: finished",
            "high: digital_out*2*",
            "*info*said",
        ]
    )


def test_cell_is_a_robot_among_what_a_file_says(pytester, plugin_arguments):
    (pytester.path / "grip.scene.json").write_text(
        '{"devices": [{"type": "two-finger", "name": "hand", "part": 0.03}]}', encoding="utf-8"
    )
    (pytester.path / "plc.scene.json").write_text(
        '{"devices": [{"type": "modbus", "name": "plc", "address": "192.168.0.20",'
        ' "values": {"register[3]": 17}}]}',
        encoding="utf-8",
    )
    pytester.makepyfile(
        """
        import pytest

        @pytest.mark.cell("grip.scene.json")
        @pytest.mark.robot(arm="ideal")
        def test_grips(cell):
            assert cell.devices["hand"].part_m == 0.03
            cell.put_part("hand", 0.05)
            cell.advance(frames=1)
            assert cell.devices["hand"].part_m == 0.05

        def test_needs_a_file(cell):
            pass

        @pytest.mark.cell("plc.scene.json")
        @pytest.mark.robot(arm="ideal")
        def test_sets_signals(cell):
            assert cell.devices["plc"].signals["register[3]"] == 17
            cell.set_signal("plc.coil[0]", True)
            cell.advance(frames=1)
            assert cell.devices["plc"].signals["coil[0]"] == 1
        """
    )
    result = pytester.runpytest_inprocess("--strict-markers", *plugin_arguments)
    result.assert_outcomes(passed=2, errors=1)
    result.stdout.fnmatch_lines(["*the fixture cell needs the marker cell, with a file*"])
