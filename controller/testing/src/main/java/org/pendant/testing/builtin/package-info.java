/**
 * Test builtins: functions that exist in tests of robot programs alone: assertions, expectations
 * over time, the program under test, the world around it, and mocks. Open {@link
 * org.pendant.testing.builtin.TestBuiltins} first.
 */
package org.pendant.testing.builtin;
