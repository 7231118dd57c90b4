/**
 * Mutation of programs under test: small mistakes are made in them, one at a time, to see whether
 * the tests notice; {@link org.pendant.testing.mutation.MutationRun} first.
 */
package org.pendant.testing.mutation;
