/**
 * A robot elsewhere that programs under test run on: what it tells, and what tests may do to it.
 * How it is reached is its own matter.
 */
package org.pendant.testing.remote;
