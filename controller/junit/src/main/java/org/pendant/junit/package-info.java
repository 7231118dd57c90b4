/**
 * Robots in JUnit tests: {@link org.pendant.junit.RobotUnderTest} is a robot in virtual time, and
 * {@link org.pendant.junit.Robot} gives a test one.
 */
package org.pendant.junit;
