"""What `symcheck generate` writes: certificates, recorded expectations and kernels. Not edited by hand."""
