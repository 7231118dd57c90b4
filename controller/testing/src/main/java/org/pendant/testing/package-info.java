/**
 * Tests of robot programs: files of tests are read, each test runs in a controller of its own in
 * virtual time, and what came of it is a value that reports are made from.
 */
package org.pendant.testing;
